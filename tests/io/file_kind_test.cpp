// Files that are not what their names say: read all the same, or refused by what they are.
#include "io/file_kind.h"

#include "catch.h"
#include "io/mesh/mesh_format.h"
#include "io/mesh/msh_parse.h"
#include "io/surface/surface_format.h"
#include "support/contains.h"
#include "support/domain_files.h"
#include "support/output_meshes.h"
#include "support/surface_files.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string out;
  for (const char c : text) out += c == '\n' ? end : std::string(1, c);
  return out;
}

Error surface_error(const std::string& name, const std::string& bytes) {
  const auto soup = read_surface_file(name, bytes);
  REQUIRE_FALSE(soup.has_value());
  return soup.error();
}

Error domain_error(const std::string& name, const std::string& text) {
  const auto file = read_domain_file(name, text);
  REQUIRE_FALSE(file.has_value());
  return file.error();
}

/// Name of the format, the file of a box.
std::vector<std::pair<std::string, std::string>> box_files() {
  const SurfaceSoup box = box_soup({1, 2, 3}, 1);
  return {{"obj", obj_text(box)},
          {"off", off_text(box)},
          {"stl", text_stl(box)},
          {"ply", text_ply(box)},
          {"msh", msh_text(box)}};
}

const std::string msh_head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string corner = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n";

}  // namespace

TEST_CASE("surfaces are read with any line ends and with a byte order mark") {
  for (const auto& [name, text] : box_files()) {
    INFO(name);
    for (const std::string end : {"\n", "\r\n", "\r"})
      for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
        const auto soup = read_surface_file("box." + name, mark + with_line_ends(text, end));
        INFO((soup ? std::string() : soup.error().message));
        REQUIRE(soup.has_value());
        CHECK(soup->triangles.size() == 12);
      }
  }
  CHECK(surface_error("x.obj", "v 0 0 0\rv 1 0 0\rf 1 2 9\r").where.line == 3);
}

TEST_CASE("a surface under another format's name is called by its own") {
  for (const auto& [name, text] : box_files())
    for (const SurfaceFormatInfo& other : surface_formats) {
      if (other.name == name) continue;
      INFO(name << " as " << other.name);
      const Error error = surface_error("box." + std::string(other.name), text);
      CHECK(error.code == ErrorCode::parse_error);
      CHECK(contains(error.message, "Name it ." + name + "."));
    }
  const std::string binary = binary_stl(box_soup({1, 2, 3}, 1));
  for (const char* name : {"box.obj", "box.off", "box.ply", "box.msh"})
    CHECK(contains(surface_error(name, binary).message, "looks like an STL file. Name it .stl."));
  for (const char* name : {"box.json", "box.geojson", "box.dxf", "box.poly", "box.svg"})
    CHECK(contains(domain_error(name, binary).message, "looks like an STL file. Name it .stl."));
  // What is wrong within the format that the name says is told as before.
  CHECK(contains(surface_error("x.obj", "v 0 0 0\nf 1 2 3\n").message, "from 1 to 1"));
}

TEST_CASE("archives, pages, pictures and pointers are told in every format") {
  const std::pair<std::string, std::string> wrong[] = {
      {"\x1F\x8B\x08 and so on", "gzip"},
      {"PK\x03\x04 and so on", "ZIP"},
      {"<!DOCTYPE html>\n<html></html>", "web page"},
      {"<html><head></head></html>", "web page"},
      {"404: Not Found", "not found"},
      {"%PDF-1.5\n", "PDF"},
      {"\x89PNG\r\n\x1A\n", "PNG"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:1\n", "git lfs pull"},
      {"ISO-10303-21;\nHEADER;\n", "STEP"},
      {"(1 \"TGrid 2D 2.4.1\")\n", "Fluent"},
      {"mshid=3\nndims=2\n", "JIGSAW"},
      {"glTF\x02", "glTF"}};
  for (const auto& [bytes, word] : wrong) {
    for (const SurfaceFormatInfo& format : surface_formats) {
      const Error error = surface_error("x." + std::string(format.name), bytes);
      INFO(format.name << ": " << error.message);
      CHECK(error.code == ErrorCode::parse_error);
      CHECK(contains(error.message, word));
    }
    for (const DomainFormatInfo& format : domain_formats) {
      const Error error = domain_error("x." + std::string(format.name), bytes);
      INFO(format.name << ": " << error.message);
      CHECK(error.code == ErrorCode::parse_error);
      CHECK(contains(error.message, word));
    }
    CHECK(contains(read_mesh(bytes, MeshFormat::msh).error().message, word));
  }
}

TEST_CASE("empty files are told as such in every format") {
  for (const std::string text : {"", "\n", " \r\n\t", "\xEF\xBB\xBF"}) {
    for (const SurfaceFormatInfo& format : surface_formats)
      CHECK(surface_error("x." + std::string(format.name), text).code == ErrorCode::empty);
    for (const DomainFormatInfo& format : domain_formats)
      CHECK(domain_error("x." + std::string(format.name), text).code == ErrorCode::empty);
  }
  CHECK(domain_error("", "").message == "The file is empty.");
  CHECK(surface_error("", "").message == "The file is empty.");
}

TEST_CASE("files of formats that are not read are told which are") {
  for (const char* ending : {"3mf", "glb", "gltf", "fbx", "3dm", "sldprt", "amf", "VTU", "geo"}) {
    const std::string name = std::string("part.") + ending;
    INFO(name);
    for (const Error& error : {surface_error(name, "{}"), domain_error(name, "{}")}) {
      CHECK(error.code == ErrorCode::parse_error);
      for (const std::string_view endings : {surface_endings, domain_endings})
        CHECK(contains(error.message, std::string(endings)));
    }
    CHECK_FALSE(is_surface_file(name, "v 0 0 0\n"));
  }
  CHECK(contains(surface_error("part.sldprt", "x").message, "STEP"));
  CHECK(contains(domain_error("part", "what is it").message, "not known"));
  CHECK(contains(surface_error("plate.json", "{}").message, "A surface is wanted"));
  CHECK(contains(domain_error("part.stl", "x").message, "domain in the plane is wanted"));
  CHECK_FALSE(kind_by_ending("no ending").has_value());
  CHECK_FALSE(kind_by_ending("part.obj").has_value());
}

TEST_CASE("MSH: what there is instead of faces is told") {
  const auto refusal_of = [](const std::string& elements) {
    const std::string text = msh_head + corner + elements + "$EndElements\n";
    CHECK(is_msh_in_space(text));
    CHECK_FALSE(read_mesh(text, MeshFormat::msh, MeshScope::space).has_value());
    const Error error = surface_error("x.msh", text);
    CHECK(error.code == ErrorCode::empty);
    return error.message;
  };
  CHECK(contains(refusal_of("2\n1 4 2 0 1 1 2 3 4\n2 1 2 0 1 1 2\n"), "only volume elements (1)"));
  CHECK(contains(refusal_of("1\n1 1 2 0 1 1 4\n"), "only points and lines"));
  CHECK(contains(refusal_of("1\n1 21 2 0 1 1 2 3 4\n"), "faces of higher order"));
  CHECK(contains(refusal_of("0\n"), "only nodes"));
  // A triangle in the plane and a volume are a surface, and the volume is told.
  const std::string both =
      msh_head + corner + "2\n1 4 2 0 1 1 2 3 4\n2 2 2 0 1 1 2 3\n$EndElements\n";
  CHECK(is_surface_file("x.msh", both));
  const auto soup = read_surface_file("x.msh", both);
  REQUIRE(soup.has_value());
  REQUIRE(soup->warnings.size() == 1);
  CHECK(soup->warnings[0].code == ErrorCode::ignored);
  // In the plane, kinds of elements are called by name.
  const std::string flat =
      msh_head + "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 .5 0 0\n$EndNodes\n$Elements\n1\n";
  CHECK(contains(domain_error("x.msh", flat + "1 8 2 0 1 1 2 3\n$EndElements\n").message,
                 "a line of second order"));
}

TEST_CASE("MSH: a file that was cut off is told where") {
  const std::string whole = msh_head + corner + "2\n1 2 2 0 1 1 2 3\n2 2 2 0 1 1 2 4\n";
  for (std::size_t size = msh_head.size() + 10; size < whole.size(); ++size) {
    INFO(size);
    const Error error = surface_error("x.msh", whole.substr(0, size));
    CHECK(error.code != ErrorCode::non_finite);
    if (size < msh_head.size() + 57) continue;  // no height yet
    CHECK(is_surface_file("x.msh", whole.substr(0, size)));
  }
  CHECK(contains(surface_error("x.msh", whole).message, "ends inside its section $Elements"));
  CHECK(contains(surface_error("x.msh", whole.substr(0, whole.size() - 7)).message, "cut off"));
  CHECK(contains(surface_error("x.msh", msh_head + "$Nodes\n4\n1 0 0").message, "cut off"));
}

TEST_CASE("texts that were cut off are told in their last word or line") {
  const SurfaceSoup box = box_soup({1, 2, 3}, 1);
  const std::string stl = text_stl(box), off = off_text(box);
  CHECK(contains(surface_error("x.stl", stl.substr(0, stl.find("endfacet") + 5)).message,
                 "the file may have been cut off"));
  CHECK(contains(surface_error("x.off", off.substr(0, off.size() - 3)).message,
                 "the file may have been cut off"));
}

TEST_CASE("UTF-16 and UTF-32 surfaces are called by their names") {
  for (const auto& [name, text] : box_files()) {
    std::string wide = "\xFF\xFE", wider = std::string("\xFF\xFE\0\0", 4);
    for (const char c : text) {
      wide += std::string{c, '\0'};
      wider += std::string{c, '\0', '\0', '\0'};
    }
    CHECK(contains(surface_error("x." + name, wide).message, "UTF-16"));
    CHECK(contains(surface_error("x." + name, wide.substr(2)).message, "UTF-16"));
    CHECK(contains(surface_error("x." + name, wider).message, "UTF-32"));
  }
}

TEST_CASE("meshes as they are written are no domains, and told so") {
  for (const OutputMesh& mesh : {two_region_mesh()})
    for (const MeshFormat format : {MeshFormat::geojson, MeshFormat::json}) {
      const bool geo = format == MeshFormat::geojson;
      const Error error = domain_error(geo ? "m.geojson" : "m.json", write_mesh(mesh, format));
      INFO(error.message);
      CHECK(error.code == ErrorCode::parse_error);
      CHECK(contains(error.message, "a mesh as lpquad writes it"));
      CHECK(contains(error.message, ".msh"));
    }
  // Somebody else's property of that name does not matter.
  const std::string square = R"("geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]})";
  for (const char* properties :
       {R"({"eta":"12:30"})", R"({"eta":0.9})", R"({"region":1,"eta":""})"})
    CHECK(read_domain_file("m.geojson", R"({"type":"Feature",)" + square + R"(,"properties":)" +
                                            properties + "}")
              .has_value());
  // Nor do both on what is no triangle or quad.
  CHECK(read_domain_file(
            "m.geojson",
            R"({"type":"Feature","properties":{"region":"a","eta":0.9},"geometry":)"
            R"({"type":"Polygon","coordinates":[[[0,0],[2,0],[3,1],[1,2],[0,1],[0,0]]]}})")
            .has_value());
}

TEST_CASE("numbers and corners that are wrong are repeated, with what to do") {
  const std::string comma = "Write decimals with a point: '0,5' has a comma.";
  CHECK(contains(surface_error("x.obj", "v 0,5 0 0\n").message, comma));
  CHECK(contains(surface_error("x.stl", "solid\nfacet\nvertex 0,5 0 0\n").message, comma));
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(contains(surface_error("x.obj", points + "f 0 1 2\n").message, "from 1 to 3"));
  CHECK(contains(surface_error("x.obj", points + "f 1 2 9\n").message, "vertex 9"));
  CHECK(
      contains(surface_error("x.obj", "f -1 -2 -3\n" + points).message, "no vertex stands before"));
  CHECK(contains(surface_error("x.off", "OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n").message,
                 "from 0 to 2"));
}

TEST_CASE("files without faces are told what they have") {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(contains(surface_error("x.obj", points).message, "only points or lines"));
  CHECK(contains(surface_error("x.obj", points + "f 1 2\n").message, "three corners or more"));
  CHECK(contains(surface_error("x.obj", points + "cstype bspline\n").message, "free-form"));
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\n";
  CHECK(contains(surface_error("x.ply", ply + "end_header\n0 0 0\n").message, "only points"));
  CHECK(contains(domain_error("x.svg", "<svg><text>a</text></svg>").message, "text"));
}

TEST_CASE("what a file is is found in linear time") {
  const std::string tags(3'000'000, '<');
  CHECK(contains(surface_error("x.obj", tags).message, "XML without an element"));
  CHECK(contains(domain_error("x.json", tags).message, "XML without an element"));
}

TEST_CASE("lists of points are told how to write them") {
  for (const char* text : {"0 0\n1 0\n1 1\n", "0,0\n1,0\n", "NACA 0012\n1.0 0.0\n0.5 0.1\n"}) {
    INFO(text);
    CHECK(contains(domain_error("x.dat", text).message, "a list of points. Write it as JSON"));
  }
  CHECK(
      contains(domain_error("x.json", R"({"type": "Topology", "arcs": []})").message, "TopoJSON"));
  const Error quotes = domain_error("x.json", "{'loops': []}");
  CHECK(quotes.message == "This is not valid JSON: unexpected text.");
}
