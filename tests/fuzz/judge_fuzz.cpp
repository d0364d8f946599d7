// Claim. Whatever the bytes, the judge's readers give a mesh or throw Malformed, and judging what
// they read ends with a verdict. The first byte selects the format.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "tables/check/hybrid_check.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/mesh.hpp"
#include "tables/check/mesh_check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hexatlas;
  constexpr std::array<std::string_view, 7> kEndings{".obj",  ".off", ".vtk", ".vtu",
                                                     ".mesh", ".msh", ".ply"};
  if (size == 0) return 0;
  const std::string name = "fuzz" + std::string(kEndings[data[0] % kEndings.size()]);
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    (void)check::parse_surface(name, bytes);
  } catch (const check::Malformed&) {
    // refused, as it should be
  }
  try {
    const check::Mesh mesh = check::parse_mesh(name, bytes);
    (void)check::check_mesh(mesh, nullptr);
  } catch (const check::Malformed&) {
    // refused, as it should be
  }
  try {
    (void)check::check_hybrid(check::parse_hybrid(name, bytes), nullptr);
  } catch (const check::Malformed&) {
    // refused, as it should be
  }
  try {
    (void)check::parse_points(name, bytes);
  } catch (const check::Malformed&) {
    // refused, as it should be
  }
  return 0;
}
