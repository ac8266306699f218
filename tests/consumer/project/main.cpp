// Meshes a plate with a hole and a surface file, and writes both meshes for Gmsh.
#include <lpquad/lpquad.h>
#include <lpquad/lpquad_io.h>

#include <cstdio>
#include <fstream>
#include <iterator>

// Prints what went wrong: code, sentence, place.
int fail(const lpq::Error& error) {
  std::fprintf(stderr, "%s\n", lpq::error_text(error).c_str());
  return 1;
}

bool save(const lpq::OutputMesh& mesh, const char* file) {
  std::ofstream out(file, std::ios::binary);
  out << lpq::write_mesh(mesh, lpq::MeshFormat::msh);
  return out.good();
}

int main(int count, char** arguments) {
  lpq::DomainInput plate;
  const std::vector<lpq::Vec2> outline{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  const std::vector<lpq::Vec2> hole{{0.8, 0.4}, {1.2, 0.4}, {1.2, 0.6}, {0.8, 0.6}};
  plate.regions.push_back({"plate", {outline, hole}, {}});
  const auto plane = lpq::mesh_domain(plate, {.size = 0.1});
  if (!plane) return fail(plane.error());
  std::printf("plate: %d quads, %d triangles\n", plane->report.quality.quads,
              plane->report.quality.triangles);
  if (!save(plane->mesh, "plate.msh")) return 1;

  if (count < 2) return 0;
  std::ifstream file(arguments[1], std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const auto soup = lpq::read_surface_file(arguments[1], bytes);
  if (!soup) return fail(soup.error());
  const auto shell = lpq::mesh_surface(*soup, {.size = 0.25});
  if (!shell) return fail(shell.error());
  std::printf("surface: %d quads, %d triangles\n", shell->report.quality.quads,
              shell->report.quality.triangles);
  return save(lpq::shell_output(*shell), "surface.msh") ? 0 : 1;
}
