// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/field_files.h"

#include "base/errors.h"
#include "contact/patch/gsf_file.h"

#include <cstdint>
#include <cstring>
#include <fmt/format.h>

namespace wheelrail {

namespace {

using Vector = Eigen::VectorXd;
constexpr double mm = 1e-3, MPa = 1e6; // in SI

Vector stateNumbers(const std::vector<PatchState> &state)
{
  Vector numbers(static_cast<Eigen::Index>(state.size()));
  for (std::size_t k = 0; k < state.size(); ++k)
    numbers[static_cast<Eigen::Index>(k)] = static_cast<double>(state[k]);
  return numbers;
}

void appendLittleEndian(std::string &bytes, std::uint64_t bits)
{
  for (int k = 0; k < 8; ++k)
    bytes += static_cast<char>(bits >> 8 * k & 0xff);
}

void appendLittleEndian(std::string &bytes, double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  appendLittleEndian(bytes, bits);
}

/// The arrays of a VTK XML file: their descriptions, and their blocks of bytes, each after its
/// length.
class AppendedArrays {
 public:
  void add(const char *name, const Vector &values)
  {
    if (values.size() == 0)
      return;
    begin(name, "Float64", 1, 8 * values.size());
    for (const double v : values)
      appendLittleEndian(blocks_, v);
  }
  void add(const char *name, const TangentialField &field)
  {
    if (field.x.size() == 0)
      return;
    begin(name, "Float64", 3, 24 * field.x.size());
    for (Eigen::Index k = 0; k < field.x.size(); ++k)
      for (const double v : {field.x[k], field.y[k], 0.0})
        appendLittleEndian(blocks_, v);
  }
  void add(const char *name, const std::vector<PatchState> &state)
  {
    if (state.empty())
      return;
    begin(name, "UInt8", 1, static_cast<Eigen::Index>(state.size()));
    for (const PatchState s : state)
      blocks_ += static_cast<char>(s);
  }
  const std::string &descriptions() const { return descriptions_; }
  const std::string &blocks() const { return blocks_; }

 private:
  void begin(const char *name, const char *type, int components, Eigen::Index bytes)
  {
    descriptions_ += fmt::format("        <DataArray type=\"{}\" Name=\"{}\" "
                                 "NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
                                 type, name, components, blocks_.size());
    appendLittleEndian(blocks_, static_cast<std::uint64_t>(bytes));
  }
  std::string descriptions_, blocks_;
};

/// Text that may stand in an XML comment: without "--" and without an end of line.
std::string commentText(std::string text)
{
  for (char &c : text)
    if (c == '-' || static_cast<unsigned char>(c) < ' ')
      c = c == '-' ? '_' : ' ';
  return text;
}

} // namespace

std::string vtiBytes(const PatchGrid &grid, const PatchFields &fields, const std::string &title)
{
  AppendedArrays arrays;
  arrays.add("state", fields.state);
  arrays.add("gap", fields.gap);
  arrays.add("pressure", fields.pressure);
  arrays.add("traction", fields.traction);
  arrays.add("slip", fields.slip);
  arrays.add("mu", fields.mu);
  arrays.add("temperature", fields.temperature);
  const std::string extent = fmt::format("0 {} 0 {} 0 0", grid.nx, grid.ny);
  std::string text = "<?xml version=\"1.0\"?>\n";
  text += fmt::format("<!-- {} -->\n", commentText(title));
  text += "<!-- x, y, gap: mm; pressure, traction: MPa; slip: sliding/rolling speed; temperature: "
          "K; state: 0 apart, 1 stick, 2 slip; material enters at the largest x -->\n";
  text += "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
          "header_type=\"UInt64\">\n";
  text += fmt::format("  <ImageData WholeExtent=\"{}\" Origin=\"{:.17g} {:.17g} 0\" "
                      "Spacing=\"{:.17g} {:.17g} 1\">\n",
                      extent, grid.left, grid.bottom, grid.dx, grid.dy);
  text += fmt::format("    <Piece Extent=\"{}\">\n      <CellData{}>\n", extent,
                      fields.pressure.size() > 0 ? " Scalars=\"pressure\"" : "");
  text += arrays.descriptions();
  text += "      </CellData>\n    </Piece>\n  </ImageData>\n  <AppendedData encoding=\"raw\">\n_";
  text += arrays.blocks();
  text += "\n  </AppendedData>\n</VTKFile>\n";
  return text;
}

std::vector<NamedBytes> gsfFields(const PatchGrid &grid, const PatchFields &fields,
                                  const std::string &title)
{
  std::vector<NamedBytes> files;
  SimpleField field;
  field.nx = grid.nx;
  field.ny = grid.ny;
  field.width = grid.nx * grid.dx * mm;
  field.height = grid.ny * grid.dy * mm;
  field.xOffset = grid.left * mm;
  field.yOffset = -(grid.bottom + grid.ny * grid.dy) * mm;
  field.xyUnit = "m";
  const auto add = [&](const char *name, const Vector &values, double unit, const char *unitName) {
    if (values.size() == 0)
      return;
    field.value = values * unit;
    field.zUnit = unitName;
    field.title = title.empty() ? name : fmt::format("{}: {}", name, title);
    for (char &c : field.title)
      if (static_cast<unsigned char>(c) < ' ') // one line of the head
        c = ' ';
    files.push_back({name, gsfBytes(field)});
  };
  add("state", stateNumbers(fields.state), 1.0, "");
  add("gap", fields.gap, mm, "m");
  add("pressure", fields.pressure, MPa, "Pa");
  add("traction_x", fields.traction.x, MPa, "Pa");
  add("traction_y", fields.traction.y, MPa, "Pa");
  add("slip_x", fields.slip.x, 1.0, "");
  add("slip_y", fields.slip.y, 1.0, "");
  add("mu", fields.mu, 1.0, "");
  add("temperature", fields.temperature, 1.0, "K");
  return files;
}

namespace {

void checkFinite(const std::string &stem, const PatchFields &fields)
{
  const std::pair<const char *, const Vector *> all[] = {
      {"gap", &fields.gap},
      {"pressure", &fields.pressure},
      {"traction", &fields.traction.x},
      {"traction", &fields.traction.y},
      {"slip", &fields.slip.x},
      {"slip", &fields.slip.y},
      {"mu", &fields.mu},
      {"temperature", &fields.temperature},
  };
  for (const auto &[name, values] : all)
    if (!values->allFinite())
      throw Error(ExitCode::NotConverged,
                  fmt::format("{}: {} is not finite everywhere", stem, name));
}

} // namespace

void addFieldFiles(mcawr::OutputFiles &files, const std::string &stem, const PatchGrid &grid,
                   const PatchFields &fields, const std::string &title)
{
  checkFinite(stem, fields);
  files.add(stem + ".vti", vtiBytes(grid, fields, title));
  for (const NamedBytes &file : gsfFields(grid, fields, title))
    files.add(fmt::format("{}_{}.gsf", stem, file.name), file.bytes);
}

} // namespace wheelrail
