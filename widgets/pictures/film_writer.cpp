#include "pictures/film_writer.h"

#include "base/error.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <system_error>
#include <utility>

namespace voluta::pictures {

namespace {
template <auto Free> struct Frees {
  template <typename T> void operator()(T* object) const { Free(&object); }
};
using Codec = std::unique_ptr<AVCodecContext, Frees<avcodec_free_context>>;
using Frame = std::unique_ptr<AVFrame, Frees<av_frame_free>>;
using Packet = std::unique_ptr<AVPacket, Frees<av_packet_free>>;

struct FreesContainer {
  void operator()(AVFormatContext* container) const {
    avio_closep(&container->pb);
    avformat_free_context(container);
  }
};
struct FreesScaler {
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};
} // namespace

struct FilmWriter::Impl {
  std::filesystem::path file, staged;
  std::unique_ptr<AVFormatContext, FreesContainer> container;
  Codec codec;
  AVStream* stream = nullptr;
  std::unique_ptr<SwsContext, FreesScaler> scaler;
  Frame frame;
  Packet packet;
  std::int64_t frames = 0;
  bool finished = false;

  ~Impl() {
    if (finished)
      return;
    container.reset();
    std::error_code none;
    std::filesystem::remove(staged, none);
  }

  [[noreturn]] void fail() const {
    throw base::Error(base::ErrorCode::CannotWrite, "the film cannot be written"_text,
                      file.string(), "choose another folder, or check the space on the disk"_text);
  }
  void check(bool isGood) const {
    if (!isGood)
      fail();
  }

  void open(int width, int height, int framesPerS) {
    const AVCodec* encoder = avcodec_find_encoder_by_name("libvpx-vp9");
    if (!encoder)
      throw base::Error(base::ErrorCode::CannotWrite,
                        "the film cannot be written: FFmpeg has no encoder for VP9"_text,
                        file.string());
    AVFormatContext* made = nullptr;
    check(avformat_alloc_output_context2(&made, nullptr, "webm", staged.c_str()) >= 0);
    container.reset(made);
    codec.reset(avcodec_alloc_context3(encoder));
    codec->width = width;
    codec->height = height;
    codec->pix_fmt = AV_PIX_FMT_YUV420P;
    codec->time_base = {1, framesPerS};
    codec->framerate = {framesPerS, 1};
    codec->gop_size = 10 * framesPerS;
    codec->thread_count = 1; // the same bytes on every machine
    // Constant quality, without a limit of the bit rate.
    codec->bit_rate = 0;
    av_opt_set(codec->priv_data, "crf", "30", 0);
    av_opt_set(codec->priv_data, "deadline", "realtime", 0);
    av_opt_set(codec->priv_data, "cpu-used", "6", 0);
    container->flags |= AVFMT_FLAG_BITEXACT;
    check(avcodec_open2(codec.get(), encoder, nullptr) >= 0);
    stream = avformat_new_stream(container.get(), nullptr);
    check(stream && avcodec_parameters_from_context(stream->codecpar, codec.get()) >= 0);
    stream->time_base = codec->time_base;
    check(avio_open(&container->pb, staged.c_str(), AVIO_FLAG_WRITE) >= 0);
    check(avformat_write_header(container.get(), nullptr) >= 0);
    scaler.reset(sws_getContext(width, height, AV_PIX_FMT_RGB24, width, height, codec->pix_fmt,
                                SWS_BILINEAR, nullptr, nullptr, nullptr));
    frame.reset(av_frame_alloc());
    packet.reset(av_packet_alloc());
    check(scaler && frame && packet);
    frame->width = width;
    frame->height = height;
    frame->format = codec->pix_fmt;
    check(av_frame_get_buffer(frame.get(), 0) >= 0);
  }

  // Encodes a frame, or what is left if there is none, and writes what is ready.
  void encode(const AVFrame* next) {
    check(avcodec_send_frame(codec.get(), next) >= 0);
    for (;;) {
      const int answer = avcodec_receive_packet(codec.get(), packet.get());
      if (answer == AVERROR(EAGAIN) || answer == AVERROR_EOF)
        return;
      check(answer >= 0);
      av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
      packet->stream_index = stream->index;
      check(av_interleaved_write_frame(container.get(), packet.get()) >= 0);
    }
  }
};

std::filesystem::path stagedFilm(const std::filesystem::path& film) {
  std::filesystem::path staged = film;
  staged += ".part";
  return staged;
}

FilmWriter::FilmWriter(std::filesystem::path file, int width, int height, int framesPerS)
    : impl_(std::make_unique<Impl>()) {
  base::require(width > 0 && height > 0 && width % 2 == 0 && height % 2 == 0 && framesPerS >= 1,
                "a film of even size");
  av_log_set_level(AV_LOG_QUIET);
  impl_->staged = stagedFilm(file);
  impl_->file = std::move(file);
  impl_->open(width, height, framesPerS);
}

FilmWriter::~FilmWriter() = default;

void FilmWriter::add(const scene::Image& image) {
  Impl& film = *impl_;
  base::require(image.width == film.codec->width && image.height == film.codec->height,
                "a frame of the film's size");
  film.check(av_frame_make_writable(film.frame.get()) >= 0);
  const std::uint8_t* rows[] = {image.rgb.data()};
  const int stride[] = {3 * image.width};
  sws_scale(film.scaler.get(), rows, stride, 0, image.height, film.frame->data,
            film.frame->linesize);
  film.frame->pts = film.frames++;
  film.encode(film.frame.get());
}

void FilmWriter::finish() {
  Impl& film = *impl_;
  film.encode(nullptr);
  film.check(av_write_trailer(film.container.get()) >= 0);
  film.container.reset();
  std::error_code error;
  std::filesystem::rename(film.staged, film.file, error);
  film.check(!error);
  film.finished = true;
}

} // namespace voluta::pictures
