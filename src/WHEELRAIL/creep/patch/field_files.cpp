// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/field_files.h"

#include "base/errors.h"
#include "base/si.h"
#include "contact/patch/formats/gsf_file.h"

#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <functional>
#include <utility>

namespace wheelrail {

namespace {

using Vector = Eigen::VectorXd;

/// A field of real numbers, of one component or of two.
struct FieldRow {
  const char *name;
  const char *siUnit; ///< of .gsf files; empty: pure number
  double scale;       ///< the unit of `PatchFields` in that one
  Vector PatchFields::*values;
  TangentialField PatchFields::*vectors; ///< in place of `values`
};

constexpr FieldRow fieldTable[] = {
    {"gap", "m", mm, &PatchFields::gap, nullptr},
    {"pressure", "Pa", MPa, &PatchFields::pressure, nullptr},
    {"traction", "Pa", MPa, nullptr, &PatchFields::traction},
    {"slip", "", 1.0, nullptr, &PatchFields::slip},
    {"mu", "", 1.0, &PatchFields::mu, nullptr},
    {"temperature", "K", 1.0, &PatchFields::temperature, nullptr},
};

constexpr const char *stateName = "state"; // the only field of whole numbers

/// A component of a row: "traction_x".
struct FieldComponent {
  std::string name;
  const FieldRow *row;
  Vector TangentialField::*part; ///< null: of the row's `values`
  const char *siUnit;
  double scale;

  const Vector &of(const PatchFields &fields) const
  {
    return part ? fields.*row->vectors.*part : fields.*row->values;
  }
};

/// \param slipIsShift  as `PatchFields` has it
std::vector<FieldComponent> fieldComponents(bool slipIsShift = false)
{
  std::vector<FieldComponent> components;
  for (const FieldRow &row : fieldTable) {
    const bool isShift = slipIsShift && row.vectors == &PatchFields::slip;
    const char *unit = isShift ? "m" : row.siUnit;
    const double scale = isShift ? mm : row.scale;
    const std::string name = row.name;
    if (row.values) {
      components.push_back({name, &row, nullptr, unit, scale});
    } else {
      components.push_back({name + "_x", &row, &TangentialField::x, unit, scale});
      components.push_back({name + "_y", &row, &TangentialField::y, unit, scale});
    }
  }
  return components;
}

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

/// The arrays of a VTK XML file: their descriptions, which stand before all of them, and their
/// blocks of bytes, each after its length. It refers to what is added.
class AppendedArrays {
 public:
  void add(const char *name, const Vector &values)
  {
    add(name, "Float64", 1, 8 * values.size(), [&values](std::string &bytes) {
      for (const double v : values)
        appendLittleEndian(bytes, v);
    });
  }
  void add(const char *name, const TangentialField &field)
  {
    add(name, "Float64", 3, 24 * field.x.size(), [&field](std::string &bytes) {
      for (Eigen::Index k = 0; k < field.x.size(); ++k)
        for (const double v : {field.x[k], field.y[k], 0.0})
          appendLittleEndian(bytes, v);
    });
  }
  void add(const char *name, const std::vector<PatchState> &state)
  {
    add(name, "UInt8", 1, static_cast<Eigen::Index>(state.size()), [&state](std::string &bytes) {
      for (const PatchState s : state)
        bytes += static_cast<char>(s);
    });
  }
  const std::string &descriptions() const { return descriptions_; }
  /// Bytes of all blocks together.
  std::size_t size() const { return size_; }
  void appendTo(std::string &bytes) const
  {
    for (const Block &block : blocks_) {
      appendLittleEndian(bytes, block.bytes);
      block.fill(bytes);
    }
  }

 private:
  struct Block {
    std::uint64_t bytes;
    std::function<void(std::string &)> fill;
  };
  void add(const char *name, const char *type, int components, Eigen::Index bytes,
           std::function<void(std::string &)> fill)
  {
    if (bytes == 0)
      return;
    descriptions_ += fmt::format("        <DataArray type=\"{}\" Name=\"{}\" "
                                 "NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
                                 type, name, components, size_);
    blocks_.push_back({static_cast<std::uint64_t>(bytes), std::move(fill)});
    size_ += sizeof(std::uint64_t) + static_cast<std::size_t>(bytes);
  }
  std::string descriptions_;
  std::vector<Block> blocks_;
  std::size_t size_ = 0;
};

/// Text that may stand in an XML comment: without "--" and without an end of line.
std::string commentText(std::string text)
{
  char former = ' ';
  for (char &c : text) {
    if (c == '-' && former == '-')
      c = '_';
    else if (static_cast<unsigned char>(c) < ' ')
      c = ' ';
    former = c;
  }
  return text;
}

} // namespace

std::string vtiBytes(const PatchGrid &grid, const PatchFields &fields, const std::string &title,
                     const ResultHead &head)
{
  AppendedArrays arrays;
  arrays.add(stateName, fields.state);
  for (const FieldRow &row : fieldTable) {
    if (row.values)
      arrays.add(row.name, fields.*row.values);
    else
      arrays.add(row.name, fields.*row.vectors);
  }
  const std::string extent = fmt::format("0 {} 0 {} 0 0", grid.nx, grid.ny);
  std::string text = "<?xml version=\"1.0\"?>\n";
  text += fmt::format("<!-- {} -->\n", commentText(title));
  text += fmt::format("<!-- x, y, gap: mm; pressure, traction: MPa; slip: {}; temperature: K; "
                      "state: 0 apart, 1 stick, 2 slip{} -->\n",
                      fields.slipIsShift ? "shift in mm" : "sliding/rolling speed",
                      fields.slipIsShift ? "" : "; material enters at the largest x");
  for (const HeadLine &line : head)
    text += fmt::format("<!-- {}: {} -->\n", line.name, commentText(line.value));
  text += "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
          "header_type=\"UInt64\">\n";
  text += fmt::format("  <ImageData WholeExtent=\"{}\" Origin=\"{:.17g} {:.17g} 0\" "
                      "Spacing=\"{:.17g} {:.17g} 1\">\n",
                      extent, grid.left, grid.bottom, grid.dx, grid.dy);
  text += fmt::format("    <Piece Extent=\"{}\">\n      <CellData{}>\n", extent,
                      fields.pressure.size() > 0 ? " Scalars=\"pressure\"" : "");
  text += arrays.descriptions();
  text += "      </CellData>\n    </Piece>\n  </ImageData>\n  <AppendedData encoding=\"raw\">\n_";
  const std::string tail = "\n  </AppendedData>\n</VTKFile>\n";
  text.reserve(text.size() + arrays.size() + tail.size()); // it may be most of the memory
  arrays.appendTo(text);
  text += tail;
  return text;
}

namespace {

/// One line of the head.
std::string withoutControls(std::string text)
{
  for (char &c : text)
    if (static_cast<unsigned char>(c) < ' ')
      c = ' ';
  return text;
}

} // namespace

std::vector<NamedField> namedFields(const PatchFields &fields)
{
  std::vector<NamedField> all;
  if (!fields.state.empty())
    all.push_back({stateName, stateNumbers(fields.state)});
  for (const FieldComponent &component : fieldComponents())
    if (Vector values = component.of(fields); values.size() > 0)
      all.push_back({component.name, std::move(values)});
  return all;
}

std::vector<std::string> gsfNames()
{
  std::vector<std::string> names = {stateName};
  for (const FieldComponent &component : fieldComponents())
    names.push_back(component.name);
  return names;
}

std::vector<NamedBytes> gsfFields(const PatchGrid &grid, const PatchFields &fields,
                                  const std::string &title, const ResultHead &head)
{
  std::vector<NamedBytes> files;
  SimpleField field;
  for (const HeadLine &line : head)
    field.notes.emplace_back(line.name, withoutControls(line.value));
  field.nx = grid.nx;
  field.ny = grid.ny;
  field.width = grid.nx * grid.dx * mm;
  field.height = grid.ny * grid.dy * mm;
  field.xOffset = grid.left * mm;
  field.yOffset = -(grid.bottom + grid.ny * grid.dy) * mm;
  field.xyUnit = "m";
  const auto add = [&](const std::string &name, const char *unit, const Vector &values) {
    if (values.size() == 0)
      return;
    field.value = values;
    field.zUnit = unit;
    field.title = withoutControls(title.empty() ? name : fmt::format("{}: {}", name, title));
    files.push_back({name, gsfBytes(field)});
  };
  add(stateName, "", stateNumbers(fields.state));
  for (const FieldComponent &component : fieldComponents(fields.slipIsShift))
    add(component.name, component.siUnit, component.of(fields) * component.scale);
  return files;
}

namespace {

void checkFinite(const std::string &stem, const PatchFields &fields)
{
  for (const FieldComponent &component : fieldComponents())
    if (!component.of(fields).allFinite())
      throw Error(ExitCode::NotConverged,
                  fmt::format("{}: {} is not finite everywhere", stem, component.row->name));
}

} // namespace

void addFieldFiles(mcawr::OutputFiles &files, const std::string &stem, const PatchGrid &grid,
                   const PatchFields &fields, const ResultHead &head, const std::string &title)
{
  checkFinite(stem, fields);
  files.add(stem + ".vti", vtiBytes(grid, fields, title, head));
  for (const NamedBytes &file : gsfFields(grid, fields, title, head))
    files.add(fmt::format("{}_{}.gsf", stem, file.name), file.bytes);
}

} // namespace wheelrail
