// Mesh files by the ending of their names.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "io/mesh/inp.h"
#include "io/mesh/msh.h"
#include "mesh/output_mesh.h"

namespace lpq {

enum class MeshFormat { obj, msh, vtu, vtk, inp, su2, bdf, ply, geojson, svg, json };

struct MeshFormatInfo {
  MeshFormat format;
  std::string_view name;     // for bindings: mesh_format_by_name
  std::string_view endings;  // of file names, the usual one first, separated by blanks
  bool in_space = true;      // holds meshes on surfaces too
};

/// Every format that can be written; help texts and error messages come from here.
inline constexpr std::array<MeshFormatInfo, 11> mesh_formats{
    {{MeshFormat::obj, "obj", ".obj"},
     {MeshFormat::msh, "msh", ".msh"},
     {MeshFormat::vtu, "vtu", ".vtu"},
     {MeshFormat::vtk, "vtk", ".vtk"},
     {MeshFormat::inp, "inp", ".inp"},
     {MeshFormat::su2, "su2", ".su2", false},
     {MeshFormat::bdf, "bdf", ".bdf .nas"},
     {MeshFormat::ply, "ply", ".ply"},
     {MeshFormat::geojson, "geojson", ".geojson"},
     {MeshFormat::svg, "svg", ".svg", false},
     {MeshFormat::json, "json", ".json"}}};

/// ".obj, .msh, ... or .json"
std::string mesh_endings();
/// Those that hold meshes on surfaces.
std::string shell_endings();
/// Can it hold a mesh on a surface?
bool is_shell_format(MeshFormat format);

/// By the file name's ending, upper or lower case.
std::optional<MeshFormat> mesh_format(std::string_view file_name);
/// By MeshFormatInfo::name, lower case.
std::optional<MeshFormat> mesh_format_by_name(std::string_view name);

struct MeshWriteOptions {
  MshVersion msh_version = MshVersion::v4_1;
  InpElement inp_element = InpElement::cps4;
};

template <class O, class F>
requires std::is_same_v<std::remove_const_t<O>, MeshWriteOptions>
void each_field(O& o, F&& visit) {
  visit("mshVersion", o.msh_version, OptionInfo{0, 0, "", "Version of .msh files."});
  visit("inpElement", o.inp_element,
        OptionInfo{0, 0, "",
                   "Elements of .inp files: plane stress, plane strain, axisymmetric or shell."});
}

/// A mesh in space needs a format that is_shell_format.
std::string write_mesh(const OutputMesh& mesh, MeshFormat format,
                       const MeshWriteOptions& options = {});

/// .obj and .msh only; the others give a parse_error that says so.
Result<OutputMesh> read_mesh(std::string_view text, MeshFormat format,
                             MeshScope scope = MeshScope::plane);

}  // namespace lpq
