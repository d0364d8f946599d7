#pragma once
/// \file
/// The page of `--report`, for people: what a verb was given, what it did, how good the mesh is,
/// and how its hexahedra lie around interior edges and vertices.
///
/// One file that needs no other, no script and no network; HTML that is XML as well; light or dark
/// as the reader likes it. Text is escaped; bytes that are not UTF-8, which names of files may
/// hold, become U+FFFD. The same report gives the same bytes, and each line of an account is one
/// line of the page.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cli/mesh_output.hpp"
#include "meshing/mesh/mesh.hpp"
#include "meshing/quality/report.hpp"
#include "tables/check/verdict.hpp"

namespace hexatlas::cli {

struct AccountLine {
  std::string label, value;
};

struct Account {
  std::string heading;
  std::vector<AccountLine> lines;

  void add(std::string label, std::string value);
  void add(std::string label, std::size_t count);
  void add_seconds(double seconds);
};

struct QualityAccount {
  std::string heading;
  quality::Report quality;
};

struct MeshReport {
  std::string title;              ///< whose mesh it is
  std::vector<Account> accounts;  ///< in the order of the page
  /// At least one; the last is that of the mesh, and leads the page.
  std::vector<QualityAccount> qualities;
};

/// Whether the judge accepts the mesh, and how the ball is proven. Requires a verdict that is
/// accepted or undecided; the latter is said to be a ball by theorem.
[[nodiscard]] Account judgement(const check::Verdict& verdict);

/// The name of a file without its folder, or the words for a standard stream.
[[nodiscard]] std::string shown_name(const std::string& path, const char* stream);

/// Writes the mesh and, if a report is wanted, its page. The page is made before, so that no file
/// is left behind without memory for it. Requires hexahedra. Cost of the page: that of
/// view::interior_valences().
void write_with_report(const MeshFiles& files, const mesh::HexMesh& mesh,
                       const std::function<MeshReport()>& report_of);

}  // namespace hexatlas::cli
