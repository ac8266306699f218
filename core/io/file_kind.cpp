// See file_kind.h.
#include "io/file_kind.h"

#include <algorithm>

#include "io/domain/domain_format.h"
#include "io/number.h"
#include "io/plain_text.h"
#include "io/surface/surface_format.h"
#include "io/text_lines.h"

namespace lpq {
namespace {

constexpr const char* as_surface = "Export the surface as STL, OBJ or PLY.";
constexpr const char* as_cad = "Export the shape as STEP, STL or OBJ.";
constexpr const char* as_drawing = "Export the drawing as DXF or SVG.";
constexpr const char* as_mesh = "Save the mesh as Gmsh's .msh, or as OBJ.";
constexpr const char* as_map = "Export the polygons as GeoJSON.";
constexpr const char* as_outline = "Export the outline as SVG or DXF.";
constexpr const char* unpack = "Unpack it first.";
constexpr const char* mesh_again =
    "Give the domain it was made from, or the mesh as .msh, of which the outline is read.";
constexpr const char* load_again = "Load the file itself, which it should have been.";

struct Ending {
  std::string_view endings;  // separated by blanks
  const char* what;
  const char* advice;
};

constexpr Ending foreign_endings[] = {
    {"3mf", "a 3MF file", as_surface},
    {"amf", "an AMF file", as_surface},
    {"glb gltf", "a glTF scene", as_surface},
    {"fbx", "an FBX scene", as_surface},
    {"dae", "a COLLADA scene", as_surface},
    {"wrl vrml x3d", "a VRML or X3D scene", as_surface},
    {"usd usda usdc usdz", "a USD scene", as_surface},
    {"blend", "a file of Blender", as_surface},
    {"3ds max", "a file of 3ds Max", as_surface},
    {"skp", "a file of SketchUp", as_surface},
    {"3dm", "a file of Rhino", as_cad},
    {"sldprt sldasm", "a file of SolidWorks", as_cad},
    {"ipt iam", "a file of Inventor", as_cad},
    {"catpart catproduct", "a file of CATIA", as_cad},
    {"prt", "a file of NX or Creo", as_cad},
    {"fcstd", "a file of FreeCAD", as_cad},
    {"f3d", "a file of Fusion", as_cad},
    {"scad", "a script of OpenSCAD", as_surface},
    {"x_t x_b xmt_txt", "a Parasolid file", as_cad},
    {"sat sab", "an ACIS file", as_cad},
    {"jt", "a JT file", as_cad},
    {"ifc", "an IFC file", as_surface},
    {"step stp iges igs brep brp", "a CAD file",
     "Give it as a surface to the program for Node or to the page, or export it as STL or OBJ."},
    {"dwg", "a DWG drawing", as_drawing},
    {"pdf", "a PDF file", as_outline},
    {"ai eps ps", "a PostScript drawing", as_outline},
    {"png jpg jpeg gif bmp tif tiff webp", "a picture made of pixels", as_outline},
    {"shp gpkg kml kmz gml", "a map", as_map},
    {"wkt wkb", "a WKT geometry", as_map},
    {"vtu vtk vtp vts pvtu", "a VTK file", as_mesh},
    {"inp", "an Abaqus file", as_mesh},
    {"bdf nas fem", "a Nastran file", as_mesh},
    {"su2", "an SU2 mesh", as_mesh},
    {"mesh meshb", "a Medit mesh", as_mesh},
    {"node ele", "a part of Triangle's files",
     "Give the .poly file, with the lines of the .node file in it."},
    {"geo geo_unrolled", "a script of Gmsh",
     "Mesh its curves (gmsh -1) or surfaces (gmsh -2), and give the .msh file."},
    {"cgns", "a CGNS file", as_mesh},
    {"unv", "a UNV file", as_mesh},
    {"med", "a MED file", as_mesh},
    {"cas neu", "a mesh of Fluent", as_mesh},
    {"xyz pts las laz e57", "a cloud of points, which has no surface", as_surface},
    {"zip gz tgz tar 7z rar xz bz2 zst", "an archive", unpack},
};

struct Signature {
  std::string_view bytes;
  const char* what;
  const char* advice;
};

constexpr Signature signatures[] = {
    {"\x1F\x8B", "a gzip archive", unpack},
    {"PK\x03\x04", "a ZIP archive (3MF files are such ones, too)",
     "Unpack it first; of a 3MF file export the surface as STL, OBJ or PLY."},
    {"7z\xBC\xAF", "a 7-Zip archive", unpack},
    {"Rar!", "a RAR archive", unpack},
    {"\xFD\x37zXZ", "an xz archive", unpack},
    {"BZh", "a bzip2 archive", unpack},
    {"\x28\xB5\x2F\xFD", "a Zstandard archive", unpack},
    {"version https://git-lfs", "a pointer of Git LFS instead of the file",
     "Load the file with git lfs pull."},
    {"%PDF", "a PDF file", as_outline},
    {"%!PS", "a PostScript drawing", as_outline},
    {"\x89PNG", "a picture made of pixels (PNG)", as_outline},
    {"\xFF\xD8\xFF", "a picture made of pixels (JPEG)", as_outline},
    {"GIF8", "a picture made of pixels (GIF)", as_outline},
    {"glTF", "a glTF scene", as_surface},
    {"Kaydara FBX", "an FBX scene", as_surface},
    {"; FBX", "an FBX scene", as_surface},
    {"BLENDER", "a file of Blender", as_surface},
    {"#VRML", "a VRML scene", as_surface},
    {"#X3D", "an X3D scene", as_surface},
    {"3D Geometry File Format", "a file of Rhino", as_cad},
    {"\xD0\xCF\x11\xE0", "a file of SolidWorks, Inventor or Office", as_cad},
    {"AC10", "a DWG drawing", as_drawing},
    {"ISO-10303-21", "a STEP file", "Name it .step."},
    {"DBRep_DrawableShape", "a BREP file", "Name it .brep."},
    {"CASCADE Topology", "a BREP file", "Name it .brep."},
    {"# vtk DataFile", "a VTK file", as_mesh},
    {"MeshVersionFormatted", "a Medit mesh", as_mesh},
    {"*HEADING", "an Abaqus file", as_mesh},
    {"*NODE", "an Abaqus file", as_mesh},
    {"\x89HDF", "an HDF5 file", as_mesh},
    {"(0 \"", "a mesh of Fluent", as_mesh},
    {"(1 \"", "a mesh of Fluent", as_mesh},
    {"mshid=", "a mesh of JIGSAW", as_mesh},
    {"$NOD", "a Gmsh mesh of version 1", "Save it as version 2.2 or 4.1."},
    {"404: Not", "the answer that a page was not found", load_again},
    {"404 Not", "the answer that a page was not found", load_again},
    {"Not Found", "the answer that a page was not found", load_again},
    {"POLYGON", "a WKT geometry", as_map},
    {"MULTIPOLYGON", "a WKT geometry", as_map},
};

bool is_among(std::string_view word, std::string_view list) {
  while (!list.empty()) {
    const std::string_view one = list.substr(0, list.find(' '));
    if (same_letters(word, one)) return true;
    list.remove_prefix(std::min(list.size(), one.size() + 1));
  }
  return false;
}

FileKind readable(const char* what, std::string_view formats, std::string_view ending) {
  return {what, "Name it ." + std::string(ending) + ".", formats};
}

/// By its outermost element, past declarations and comments.
FileKind kind_of_xml(std::string_view text) {
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    constexpr std::size_t looked_at = 64;  // of each tag, so that the cost is linear
    const std::string_view rest = text.substr(at + 1, looked_at);
    const std::string_view name = rest.substr(0, rest.find_first_of(" \t\r\n>/<"));
    if (same_letters(name, "!doctype") && same_letters(rest.substr(9, 4), "html"))
      return {"a web page (HTML)", load_again};
    if (name.empty() || name[0] == '?' || name[0] == '!') continue;
    const std::string_view local = name.substr(name.rfind(':') + 1);  // npos + 1 = 0
    if (local == "svg") return readable("an SVG drawing", "svg", "svg");
    if (same_letters(local, "html")) return {"a web page (HTML)", load_again};
    if (local == "VTKFile") return {"a VTK file", as_mesh};
    if (local == "amf") return {"an AMF file", as_surface};
    if (local == "COLLADA") return {"a COLLADA scene", as_surface};
    if (local == "X3D") return {"an X3D scene", as_surface};
    if (local == "kml" || local == "gpx" || local == "osm") return {"a map", as_map};
    return {"XML with the outermost element <" + std::string(local.substr(0, 40)) + ">",
            "Is it the file that was meant?"};
  }
  return {"XML without an element", "Is it the file that was meant?"};
}

FileKind kind_of_json(std::string_view text) {
  const auto has = [&](std::string_view part) { return text.find(part) != std::string_view::npos; };
  if (has("\"asset\"") && (has("\"meshes\"") || has("\"bufferViews\"")))
    return {"a glTF scene", as_surface};
  if (has("\"Topology\"") && has("\"arcs\"")) return {"a TopoJSON map", as_map};
  if (has("\"rings\"") && has("\"spatialReference\"")) return {"a map of ArcGIS", as_map};
  if (has("\"edgeRegions\"") && has("\"edgeTag\""))
    return {"a mesh as lpquad writes it", mesh_again};
  return {"JSON", "Only domains in the plane are read from that; name such one .json.",
          "json geojson"};
}

std::optional<FileKind> kind_of_surface(std::string_view bytes) {
  const auto format = surface_format_by_content(bytes);
  if (!format) return std::nullopt;
  switch (*format) {
    case SurfaceFormat::obj: return readable("an OBJ file", "obj", "obj");
    case SurfaceFormat::off: return readable("an OFF file", "off", "off");
    case SurfaceFormat::stl: return readable("an STL file", "stl", "stl");
    case SurfaceFormat::ply: return readable("a PLY file", "ply", "ply");
    case SurfaceFormat::msh: return readable("a Gmsh mesh", "msh", "msh");
  }
  return std::nullopt;
}

/// "stl" -> "STL"
std::string name_in_words(std::string_view format) {
  if (format == "geojson") return "GeoJSON";
  if (format == "poly") return ".poly";
  if (format == "msh") return ".msh";
  std::string letters(format);
  for (char& c : letters) c = static_cast<char>(c + 'A' - 'a');
  return letters;
}

std::string_view without_blanks(std::string_view bytes) {
  return past_blanks(bytes.substr(byte_order_mark_size(bytes)));
}

Problem empty_file(std::string_view bytes) {
  if (bytes.empty()) return Error{ErrorCode::empty, "The file is empty.", {}};
  if (without_blanks(bytes).empty())
    return Error{ErrorCode::empty, "There is nothing but blanks in the file.", {}};
  return std::nullopt;
}

/// Two or three numbers in the first or, after a title, the second line.
bool is_list_of_points(std::string_view text) {
  LineReader lines(text);
  for (int line = 0; line < 2; ++line) {
    std::string plain(lines.next());
    std::replace_if(
        plain.begin(), plain.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    Words words;
    words.split(plain);
    double number = 0;
    std::size_t numbers = 0;
    while (numbers < words.size() && parse_number(words[numbers], number)) ++numbers;
    if (numbers == words.size() && (numbers == 2 || numbers == 3)) return true;
  }
  return false;
}

}  // namespace

std::optional<FileKind> kind_by_ending(std::string_view file_name) {
  for (const Ending& one : foreign_endings)
    if (is_among(ending_of(file_name), one.endings)) return FileKind{one.what, one.advice};
  return std::nullopt;
}

std::optional<FileKind> kind_by_content(std::string_view bytes) {
  const std::string_view rest = without_blanks(bytes);
  for (const Signature& one : signatures)
    if (rest.substr(0, one.bytes.size()) == one.bytes) return FileKind{one.what, one.advice};
  if (auto surface = kind_of_surface(bytes)) return surface;
  if (rest.empty()) return std::nullopt;
  if (rest[0] == '<') return kind_of_xml(rest);
  if (rest[0] == '{' || rest[0] == '[') return kind_of_json(rest);
  const auto format = domain_format_by_content(bytes);
  if (format == DomainFormat::dxf) return readable("a DXF drawing", "dxf", "dxf");
  if (format == DomainFormat::poly) return readable("a .poly file", "poly", "poly");
  return std::nullopt;
}

Error error_of_kind(Error found, std::string_view bytes, std::string_view format) {
  if (auto empty = empty_file(bytes)) return *std::move(empty);
  const auto kind = kind_by_content(bytes);
  if (!kind || is_among(format, kind->formats)) return found;
  return {ErrorCode::parse_error,
          "This cannot be read as " + name_in_words(format) + ": it looks like " + kind->what +
              ". " + kind->advice,
          {}};
}

Error unknown_format(std::string_view file_name, std::string_view bytes) {
  auto kind = kind_by_ending(file_name);
  std::string text;
  if (domain_format_by_ending(file_name)) {
    text = "A surface is wanted here, and by its name this is a domain in the plane.";
  } else if (surface_format_by_ending(file_name)) {
    text = "A domain in the plane is wanted here, and by its name this is a surface.";
  } else if (kind) {
    text = "This is " + kind->what + " by its name, which cannot be read. " + kind->advice;
  } else {
    if (auto empty = empty_file(bytes)) return *std::move(empty);
    kind = kind_by_content(bytes);
    if (!kind && is_list_of_points(bytes))
      kind = FileKind{"a list of points", "Write it as JSON: {\"loops\": [[[x, y], [x, y], ..]]}."};
    text = kind ? "This looks like " + kind->what + ". " + kind->advice
                : "The format of this file is not known.";
  }
  text += " Surfaces are read from " + std::string(surface_endings) +
          " files, and from STEP, IGES and BREP by the programs for Node and the web; domains in "
          "the plane from " +
          std::string(domain_endings) + " files.";
  return {ErrorCode::parse_error, std::move(text), {}};
}

}  // namespace lpq
