// The kernel that Debian's libgmsh exports without a header: what is declared here is as much of
// its interface as is used.
#include <cstdlib>

#include "experiments/2026-11-delaunay-peers/common.hpp"

struct HxtMesh {
  double* coordinates;  // four per vertex
  std::uint32_t count, room;
};
struct HxtOptions {
  void *box = nullptr, *sizes = nullptr;
  std::uint32_t in_mesh = 0, first = 0;
  double partitionability = 0;
  int perfect = 1, verbosity = 0, reproducible = 0, threads = 1;
};
extern "C" int hxtMeshCreate(HxtMesh** mesh);
extern "C" int hxtDelaunay(HxtMesh* mesh, HxtOptions* options);

int main(int count, char** words) {
  Run run(count, words);
  HxtMesh* mesh = nullptr;
  if (hxtMeshCreate(&mesh) != 0) return 1;
  mesh->coordinates = static_cast<double*>(std::aligned_alloc(64, (32 * run.n + 63) / 64 * 64));
  mesh->count = mesh->room = static_cast<std::uint32_t>(run.n);
  for (std::size_t i = 0; i < run.n; ++i)
    for (int k = 0; k < 3; ++k) mesh->coordinates[4 * i + k] = run.xyz[3 * i + k];
  std::vector<double>().swap(run.xyz);
  HxtOptions options;
  options.threads = run.threads;
  run.begin();
  const int status = hxtDelaunay(mesh, &options);
  run.end();
  if (status != 0) return 1;
  run.report("hxt", 0);
}
