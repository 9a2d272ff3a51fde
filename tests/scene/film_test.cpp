// A film of a printed box is read back and compared with pictures of the same moments.
#include "base/error.h"
#include "helpers/temporary_folder.h"
#include "pictures/job_film.h"
#include "pipeline/box_request.h"
#include "pipeline/plan_result.h"
#include "plan/arrival_times.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <vector>

using namespace voluta;

namespace {

struct ReadFilm {
  std::string container, codec;
  double lengthS = 0.0;
  std::vector<scene::Image> frames;
};

scene::Image imageOf(const AVFrame& frame) {
  scene::Image image{frame.width, frame.height, {}};
  image.rgb.resize(static_cast<std::size_t>(3 * frame.width * frame.height));
  SwsContext* scaler = sws_getContext(
      frame.width, frame.height, static_cast<AVPixelFormat>(frame.format), frame.width,
      frame.height, AV_PIX_FMT_RGB24, SWS_BILINEAR, nullptr, nullptr, nullptr);
  std::uint8_t* rows[] = {image.rgb.data()};
  const int stride[] = {3 * frame.width};
  sws_scale(scaler, frame.data, frame.linesize, 0, frame.height, rows, stride);
  sws_freeContext(scaler);
  return image;
}

ReadFilm readFilm(const std::filesystem::path& file) {
  ReadFilm film;
  AVFormatContext* container = nullptr;
  if (avformat_open_input(&container, file.c_str(), nullptr, nullptr) < 0)
    return film;
  avformat_find_stream_info(container, nullptr);
  film.container = container->iformat->name;
  film.lengthS = static_cast<double>(container->duration) / AV_TIME_BASE;
  const AVCodecParameters* parameters = container->streams[0]->codecpar;
  film.codec = avcodec_get_name(parameters->codec_id);
  AVCodecContext* codec = avcodec_alloc_context3(avcodec_find_decoder(parameters->codec_id));
  avcodec_parameters_to_context(codec, parameters);
  avcodec_open2(codec, nullptr, nullptr);
  AVPacket* packet = av_packet_alloc();
  AVFrame* frame = av_frame_alloc();
  const auto take = [&](const AVPacket* next) {
    avcodec_send_packet(codec, next);
    while (avcodec_receive_frame(codec, frame) >= 0)
      film.frames.push_back(imageOf(*frame));
  };
  while (av_read_frame(container, packet) >= 0) {
    take(packet);
    av_packet_unref(packet);
  }
  take(nullptr);
  av_frame_free(&frame);
  av_packet_free(&packet);
  avcodec_free_context(&codec);
  avformat_close_input(&container);
  return film;
}

// Mean difference of a channel, of 255.
double difference(const scene::Image& a, const scene::Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i)
    sum += std::abs(a.rgb[i] - b.rgb[i]);
  return sum / static_cast<double>(a.rgb.size());
}

pictures::FilmOptions shortFilm() {
  pictures::FilmOptions options;
  options.look.width = 321; // becomes even
  options.look.height = 180;
  options.look.legend = false;
  options.lengthS = 1.0;
  options.framesPerS = 10;
  return options;
}

TEST(Film, ShowsTheProgramFromItsStartToItsEnd) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "box.webm";
  const project::Job& job = test::boxPlan().job;
  pictures::writeFilm(job, shortFilm(), file, base::RunContext());
  const ReadFilm film = readFilm(file);
  EXPECT_NE(film.container.find("webm"), std::string::npos) << film.container;
  EXPECT_EQ(film.codec, "vp9");
  EXPECT_NEAR(film.lengthS, 1.0, 0.11);
  ASSERT_EQ(film.frames.size(), 10u);
  pictures::PictureOptions picture = shortFilm().look;
  picture.width = 320;
  picture.show = "robot";
  const double endS = plan::arrivalTimes(*job.trajectory).back();
  const auto pictureAt = [&](int frame) {
    picture.timeS = frame / 9.0 * endS;
    return pictures::jobPicture(job, picture);
  };
  for (const int frame : {0, 5, 9}) {
    const scene::Image moment = pictureAt(frame);
    const scene::Image& shown = film.frames[static_cast<std::size_t>(frame)];
    ASSERT_EQ(shown.width, moment.width);
    EXPECT_LT(difference(shown, moment), 4.0) << frame;
  }
  EXPECT_LT(difference(film.frames[5], pictureAt(5)), difference(film.frames[5], pictureAt(0)));
}

TEST(Film, IsWholeOrNotThere) {
  const test::TemporaryFolder folder;
  const project::Job& job = test::boxPlan().job;
  const base::RunContext ctx;
  base::CancelToken cancel;
  int reports = 0;
  const base::RunContext cancelled(cancel, 1, [&](const auto&...) {
    if (++reports > 3)
      cancel.cancel();
  });
  EXPECT_THROW(pictures::writeFilm(job, shortFilm(), folder / "cut.webm", cancelled),
               base::Cancelled);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_THROW(pictures::writeFilm(job, shortFilm(), folder / "none/film.webm", ctx), base::Error);
  project::Job unplanned = job;
  unplanned.trajectory = nullptr;
  EXPECT_THROW(pictures::writeFilm(unplanned, shortFilm(), folder / "film.webm", ctx), base::Error);
  pictures::FilmOptions none = shortFilm();
  none.lengthS = 0.0;
  EXPECT_THROW(pictures::writeFilm(job, none, folder / "film.webm", ctx), base::Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

} // namespace
