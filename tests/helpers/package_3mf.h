// 3MF packages around a model, as programs write them.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <zlib.h>

namespace voluta::test {

class ZipWriter {
public:
  explicit ZipWriter(bool deflates) : deflates_(deflates) {}

  void add(std::string_view name, const std::string& bytes) {
    const std::string packed = deflates_ ? deflated(bytes) : bytes;
    std::string common; // to both of a member's headers: versions to the length of its name
    put(common, 20, 2);
    put(common, 0, 2);
    put(common, deflates_ ? 8 : 0, 2);
    put(common, 0, 4); // time and date
    put(common, crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), size(bytes)), 4);
    put(common, packed.size(), 4);
    put(common, bytes.size(), 4);
    put(common, name.size(), 2);
    put(common, 0, 2);
    put(directory_, 0x02014b50, 4);
    put(directory_, 20, 2);
    directory_ += common;
    put(directory_, 0, 10);
    put(directory_, members_.size(), 4);
    directory_ += name;
    put(members_, 0x04034b50, 4);
    members_.append(common).append(name).append(packed);
    ++count_;
  }
  std::string bytes() const {
    std::string end;
    put(end, 0x06054b50, 4);
    put(end, 0, 4);
    put(end, count_, 2);
    put(end, count_, 2);
    put(end, directory_.size(), 4);
    put(end, members_.size(), 4);
    put(end, 0, 2);
    return members_ + directory_ + end;
  }

private:
  static uInt size(const std::string& bytes) { return static_cast<uInt>(bytes.size()); }
  static void put(std::string& to, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i, value >>= 8)
      to += static_cast<char>(value & 0xff);
  }
  static std::string deflated(const std::string& bytes) {
    z_stream stream{};
    if (deflateInit2(&stream, 6, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::runtime_error("deflateInit2");
    std::string packed(deflateBound(&stream, size(bytes)), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = size(bytes);
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = size(packed);
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
  }

  bool deflates_;
  std::string members_, directory_;
  std::uint64_t count_ = 0;
};

// `further`: a model beside it, 3D/further.model.
inline std::string package3mf(const std::string& model, bool deflates = true,
                              const std::string& further = {}) {
  ZipWriter zip(deflates);
  zip.add("[Content_Types].xml",
          "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
          "<Default Extension=\"model\" "
          "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>");
  zip.add("_rels/.rels",
          "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
          "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
          "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
          "</Relationships>");
  zip.add("3D/3dmodel.model", model);
  if (!further.empty())
    zip.add("3D/further.model", further);
  return zip.bytes();
}

} // namespace voluta::test
