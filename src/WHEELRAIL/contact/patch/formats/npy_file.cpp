// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/text_lines.h"
#include "contact/patch/formats/height_map_formats.h"
#include "contact/patch/formats/map_text.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <map>

namespace wheelrail {

namespace {

/// The head of an npy file: the literal of a Python dictionary with three entries of known kinds.
/// Any order of entries, blanks and a last comma, as numpy's own reader takes them; nothing is
/// evaluated.
class NpyHead {
 public:
  NpyHead(const std::string &path, std::string_view text, std::size_t offset)
      : path_(path), text_(text), offset_(offset)
  {
    expect('{');
    while (!accept('}')) {
      readEntry();
      if (!accept(',')) {
        expect('}');
        break;
      }
    }
    if (!trimmedView(text_.substr(at_)).empty())
      fail("more text after the dictionary");
    if (type.empty() || shape.empty() || !hasOrder_)
      fail("descr, fortran_order and shape are needed");
  }

  std::string type;
  bool fortranOrder = false;
  std::vector<long> shape;

 private:
  [[noreturn]] void fail(const std::string &problem) const
  {
    throw badInput(path_, 0, fmt::format("byte {}", offset_ + at_), "head: " + problem);
  }
  void skipBlanks()
  {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t'))
      ++at_;
  }
  bool accept(char wanted)
  {
    skipBlanks();
    if (at_ >= text_.size() || text_[at_] != wanted)
      return false;
    ++at_;
    return true;
  }
  void expect(char wanted)
  {
    if (!accept(wanted))
      fail(fmt::format("'{}' is missing", wanted));
  }
  std::string readString()
  {
    const char quote = accept('\'') ? '\'' : '"';
    if (quote == '"')
      expect('"');
    const auto end = text_.find(quote, at_);
    if (end == std::string_view::npos)
      fail("a text without its end");
    std::string value(text_.substr(at_, end - at_));
    at_ = end + 1;
    return value;
  }
  std::string readWord()
  {
    skipBlanks();
    const auto end = std::min(text_.find_first_of(" ,)}", at_), text_.size());
    std::string word(text_.substr(at_, end - at_));
    at_ = end;
    return word;
  }
  void readEntry()
  {
    const std::string name = readString();
    expect(':');
    if (name == "descr") {
      skipBlanks();
      if (at_ < text_.size() && text_[at_] == '[')
        fail("an array of records; float32 and float64 are read");
      type = readString();
    } else if (name == "fortran_order") {
      const std::string word = readWord();
      if (word != "True" && word != "False")
        fail(fmt::format("fortran_order '{}'; True and False are allowed", word));
      fortranOrder = word == "True";
      hasOrder_ = true;
    } else if (name == "shape") {
      expect('(');
      while (!accept(')')) {
        shape.push_back(wholeNumber(path_, 0, "shape", readWord()));
        if (!accept(',')) {
          expect(')');
          break;
        }
      }
    } else {
      fail(fmt::format("unknown entry '{}'", name));
    }
  }

  const std::string &path_;
  std::string_view text_;
  std::size_t offset_, at_ = 0;
  bool hasOrder_ = false;
};

std::uint64_t wholeOf(const char *bytes, int size, bool bigEndian)
{
  std::uint64_t value = 0;
  for (int k = 0; k < size; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes[bigEndian ? k : size - 1 - k]);
  return value;
}

double floatOf(const char *bytes, int size, bool bigEndian)
{
  const std::uint64_t bits = wholeOf(bytes, size, bigEndian);
  if (size == 4) {
    const auto half = static_cast<std::uint32_t>(bits);
    float value = 0.0F;
    std::memcpy(&value, &half, sizeof value);
    return value;
  }
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Where the head's text begins and ends. \throws Error (BadInput)
std::pair<std::size_t, std::size_t> headOf(const std::string &path, const std::string &bytes)
{
  constexpr std::size_t beforeLength = 8; // magic, version
  if (bytes.size() < beforeLength + 4)
    throw badInput(path, 0, "", fmt::format("{} bytes are not an npy file", bytes.size()));
  const int major = static_cast<unsigned char>(bytes[6]);
  if (major < 1 || major > 3)
    throw badInput(path, 0, "byte 6", fmt::format("version {}; 1, 2 and 3 are read", major));
  const int width = major == 1 ? 2 : 4;
  const std::size_t begin = beforeLength + width;
  const std::uint64_t length = wholeOf(bytes.data() + beforeLength, width, false);
  if (length > bytes.size() - begin)
    throw badInput(path, 0, fmt::format("byte {}", beforeLength),
                   fmt::format("a head of {} bytes; the file has {}", length, bytes.size()));
  return {begin, begin + length};
}

} // namespace

HeightMap parseNpy(const std::string &path, const std::string &bytes, const HeightMapScale &scale)
{
  const auto [begin, data] = headOf(path, bytes);
  const NpyHead head(path, std::string_view(bytes).substr(begin, data - begin), begin);
  if (head.type != "<f4" && head.type != "<f8" && head.type != ">f4" && head.type != ">f8")
    throw badInput(
        path, 0, "descr",
        fmt::format("'{}'; float32 and float64 (<f4, <f8, >f4, >f8) are read", head.type));
  if (head.shape.size() != 2)
    throw badInput(path, 0, "shape",
                   fmt::format("{} dimensions; two are needed", head.shape.size()));
  const long ny = head.shape[0], nx = head.shape[1];
  checkMapSize(path, 0, "shape", nx, ny);
  const int width = head.type[2] - '0';
  const std::size_t expected = data + static_cast<std::size_t>(nx * ny) * width;
  if (bytes.size() != expected)
    throw badInput(path, 0, "",
                   fmt::format("{} bytes; {} x {} values of {} bytes after the head make {}",
                               bytes.size(), ny, nx, width, expected));

  HeightMap map{static_cast<int>(nx), static_cast<int>(ny), scale.spacingX, scale.spacingY,
                Eigen::VectorXd(nx * ny)};
  const bool bigEndian = head.type[0] == '>';
  for (long iy = 0; iy < ny; ++iy)
    for (long ix = 0; ix < nx; ++ix) {
      const long place = head.fortranOrder ? iy + ny * ix : ix + nx * iy;
      const double value = floatOf(bytes.data() + data + place * width, width, bigEndian);
      if (std::isinf(value))
        throw badInput(path, 0, fmt::format("[{}, {}]", iy, ix), "infinite");
      map.height[ix + nx * (ny - 1 - iy)] = value * scale.heightUnit;
    }
  return map;
}

} // namespace wheelrail
