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
  // `is64`: sizes, places and counts are where the 64-bit extension has them.
  explicit ZipWriter(bool deflates, bool is64 = false) : deflates_(deflates), is64_(is64) {}

  void add(std::string_view name, const std::string& bytes) {
    const std::string packed = deflates_ ? deflated(bytes) : bytes;
    std::string common; // to both of a member's headers: versions to the length of its name
    put(common, is64_ ? 45 : 20, 2);
    put(common, 0, 2);
    put(common, deflates_ ? 8 : 0, 2);
    put(common, 0, 4); // time and date
    put(common, crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), size(bytes)), 4);
    put(common, is64_ ? kMax : packed.size(), 4);
    put(common, is64_ ? kMax : bytes.size(), 4);
    put(common, name.size(), 2);
    std::string sizes;
    put(sizes, bytes.size(), 8);
    put(sizes, packed.size(), 8);
    const std::string local = is64_ ? extra(sizes) : std::string();
    put(sizes, members_.size(), 8);
    const std::string central = is64_ ? extra(sizes) : std::string();
    put(directory_, 0x02014b50, 4);
    put(directory_, 20, 2);
    directory_ += common;
    put(directory_, central.size(), 2);
    put(directory_, 0, 10);
    put(directory_, is64_ ? kMax : members_.size(), 4);
    directory_.append(name).append(central);
    put(members_, 0x04034b50, 4);
    members_ += common;
    put(members_, local.size(), 2);
    members_.append(name).append(local).append(packed);
    ++count_;
  }
  std::string bytes() const {
    std::string end;
    if (is64_) {
      put(end, 0x06064b50, 4);
      put(end, 44, 8);
      put(end, 45 | 45 << 16, 4);
      put(end, 0, 8);
      put(end, count_, 8);
      put(end, count_, 8);
      put(end, directory_.size(), 8);
      put(end, members_.size(), 8);
      put(end, 0x07064b50, 4);
      put(end, 0, 4);
      put(end, members_.size() + directory_.size(), 8);
      put(end, 1, 4);
    }
    put(end, 0x06054b50, 4);
    put(end, 0, 4);
    put(end, is64_ ? 0xffff : count_, 2);
    put(end, is64_ ? 0xffff : count_, 2);
    put(end, is64_ ? kMax : directory_.size(), 4);
    put(end, is64_ ? kMax : members_.size(), 4);
    put(end, 0, 2);
    return members_ + directory_ + end;
  }

private:
  static constexpr std::uint64_t kMax = 0xffffffffu;
  static std::string extra(const std::string& sizes) {
    std::string field;
    put(field, 1, 2);
    put(field, sizes.size(), 2);
    return field + sizes;
  }
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

  bool deflates_, is64_;
  std::string members_, directory_;
  std::uint64_t count_ = 0;
};

// Adds the files that every package has; the model is to be added.
inline void addRelations(ZipWriter& zip) {
  zip.add("[Content_Types].xml",
          "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
          "<Default Extension=\"model\" "
          "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>");
  zip.add("_rels/.rels",
          "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
          "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
          "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
          "</Relationships>");
}

// `further`: a model beside it, 3D/further.model.
inline std::string package3mf(const std::string& model, bool deflates = true,
                              const std::string& further = {}) {
  ZipWriter zip(deflates);
  addRelations(zip);
  zip.add("3D/3dmodel.model", model);
  if (!further.empty())
    zip.add("3D/further.model", further);
  return zip.bytes();
}

} // namespace voluta::test
