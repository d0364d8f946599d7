#include "cli/mesh_report.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string_view>
#include <utility>

#include "cli/histogram_chart.hpp"
#include "cli/output.hpp"
#include "enum/core/checks.hpp"
#include "enum/core/files.hpp"
#include "meshing/view/structure.hpp"
#include "tables/sheet/markup.hpp"

namespace hexatlas::cli {
namespace {

constexpr std::uint32_t kRegularValence = 4;  // of an interior edge

/// For XML, which has no characters below the blank but ends of lines and tabs; in UTF-8.
std::string escaped(const std::string& words) {
  // to_line() knows what is not UTF-8.
  const std::string text = nlohmann::json::parse(to_line(words)).get<std::string>();
  std::string result;
  for (const char c : sheet::escaped(text)) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      result += "\xEF\xBF\xBD";
    else
      result += c;
  }
  return result;
}

/// Apart from the formats, in which its braces would be doubled.
constexpr std::string_view kStyle = R"(
:root {
  color-scheme: light dark;
  --paper: #ffffff; --ink: #1b2430; --muted: #586473; --line: #dde2e8;
  --bar: #2f6ea5; --inverted: #c8501e;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #14181d; --ink: #e3e7ec; --muted: #9aa5b1; --line: #303842;
    --bar: #6ba6d8; --inverted: #ee8a5a;
  }
}
* { box-sizing: border-box; }
body {
  max-width: 800px; margin: 0 auto; padding: 40px 24px 56px;
  color: var(--ink); background: var(--paper);
  font: 15px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif;
  font-variant-numeric: tabular-nums;
}
h1 { margin: 0; font-size: 26px; line-height: 1.25; font-weight: 650; overflow-wrap: anywhere; }
h2 {
  margin: 36px 0 10px; padding-top: 14px; border-top: 1px solid var(--line);
  font-size: 17px; font-weight: 650;
}
.over, .note, footer { color: var(--muted); font-size: 13px; }
.over { margin: 0 0 4px; }
.note { margin: 8px 0 0; }
dl { margin: 0; }
.figures { display: grid; grid-template-columns: repeat(4, 1fr); gap: 16px; margin-top: 24px; }
.figures > div { display: flex; flex-direction: column-reverse; }
.figures dt { color: var(--muted); font-size: 13px; }
.figures dd { margin: 0; font-size: 26px; line-height: 1.3; font-weight: 600; }
.account > div { display: grid; grid-template-columns: 190px 1fr; gap: 16px; padding: 2px 0; }
.account dt { color: var(--muted); }
.account dd { margin: 0; overflow-wrap: anywhere; }
.tables {
  display: grid; grid-template-columns: 1fr 1fr; gap: 24px 56px; align-items: start;
  margin-top: 18px;
}
table { width: 100%; border-collapse: collapse; }
caption { padding-bottom: 6px; text-align: left; font-weight: 600; }
th, td {
  padding: 3px 0 3px 16px; border-bottom: 1px solid var(--line);
  text-align: right; font-weight: 400;
}
th:first-child { padding-left: 0; }
thead th { color: var(--muted); font-size: 13px; vertical-align: bottom; }
.words th:first-child { text-align: left; }
.part th:first-child { padding-left: 16px; color: var(--muted); }
svg { display: block; width: 100%; height: auto; margin-top: 22px; overflow: visible; }
svg text { font-size: 12px; fill: var(--muted); }
svg .count { fill: var(--ink); }
svg .bar { fill: var(--bar); }
svg .inverted { fill: var(--inverted); }
svg .grid { stroke: var(--line); }
svg .axis { stroke: var(--muted); }
footer { margin-top: 40px; padding-top: 12px; border-top: 1px solid var(--line); }
@media (max-width: 560px) {
  .figures { grid-template-columns: repeat(2, 1fr); }
  .account > div, .tables { grid-template-columns: 1fr; }
  .account > div { gap: 0; }
}
)";

/// Of a whole that is not 0. Nothing and all are said of nothing and all only.
std::string share(std::size_t part, std::size_t whole) {
  const double percent = 100 * static_cast<double>(part) / static_cast<double>(whole);
  if (part > 0 && percent < 0.1) return "&lt; 0.1 %";
  if (part < whole && percent > 99.9) return "&gt; 99.9 %";
  return fmt::format("{:.1f} %", percent);
}

std::string row(const std::string& head, std::size_t count, std::size_t whole,
                const char* kind = "") {
  return fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td><td>{}</td></tr>\n", kind, head,
                     count, share(count, whole));
}

std::string table(const char* kind, const char* caption, const char* first, const char* second,
                  const std::string& rows) {
  return fmt::format(
      "<table{}>\n<caption>{}</caption>\n<thead><tr><th scope=\"col\">{}</th>"
      "<th scope=\"col\">{}</th><th scope=\"col\">share</th></tr></thead>\n<tbody>\n{}</tbody>\n"
      "</table>\n",
      kind, caption, first, second, rows);
}

constexpr const char* kWords = " class=\"words\"";

std::string figure(const char* label, const std::string& value) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", label, value);
}

std::string figures(const quality::Report& quality) {
  return "<dl class=\"figures\">\n" + figure("hexahedra", std::to_string(quality.cells)) +
         figure("not proven valid", std::to_string(quality.cells - quality.valid)) +
         figure("minimum scaled Jacobian", in_short(quality.min_scaled_jacobian)) +
         figure("mean scaled Jacobian", in_short(quality.mean_scaled_jacobian)) + "</dl>\n";
}

std::string section_of(const Account& account) {
  std::string html = fmt::format("<h2>{}</h2>\n<dl class=\"account\">\n", escaped(account.heading));
  for (const AccountLine& line : account.lines)
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(line.label),
                        escaped(line.value));
  return html + "</dl>\n";
}

std::string section_of(const QualityAccount& account, std::size_t number) {
  const quality::Report& quality = account.quality;
  const std::size_t all = quality.cells;
  std::string bins;
  for (std::size_t bin = 0; bin < quality.histogram.size(); ++bin)
    bins += row(histogram_bin(bin), quality.histogram[bin], all);
  return fmt::format("<h2>{}</h2>\n<p>Scaled Jacobian: minimum {}, mean {}.</p>\n",
                     escaped(account.heading), in_short(quality.min_scaled_jacobian),
                     in_short(quality.mean_scaled_jacobian)) +
         histogram_chart(quality, fmt::format("chart-{}", number)) + "<div class=\"tables\">\n" +
         table(kWords, "Scaled Jacobian", "interval", "hexahedra", bins) +
         table(kWords, "Validity", "hexahedra that are", "hexahedra",
               row("proven valid", quality.valid, all) + row("not valid", quality.invalid, all) +
                   row("inverted at a corner", quality.inverted, all, " class=\"part\"") +
                   row("undecided", quality.undecided, all)) +
         "</div>\n"
         "<p class=\"note\">Valid: the Jacobian determinant is proven positive in the whole "
         "hexahedron, by exact signs. Inverted: it is not positive at a corner. The scaled "
         "Jacobian "
         "is the least one at a corner; at an inverted corner it is not above 0.</p>\n";
}

std::size_t sum_of(const std::map<std::uint32_t, std::size_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0},
                         [](std::size_t sum, const auto& entry) { return sum + entry.second; });
}

std::string rows_of(const std::map<std::uint32_t, std::size_t>& counts) {
  const std::size_t all = sum_of(counts);
  std::string rows;
  for (const auto& [around, count] : counts) rows += row(std::to_string(around), count, all);
  return rows;
}

std::string section_of(const view::InteriorValences& valences) {
  const std::string heading = "<h2>Around interior edges and vertices</h2>\n";
  const std::size_t edges = sum_of(valences.edges);
  if (edges == 0) return heading + "<p>No edge is interior.</p>\n";
  const auto regular = valences.edges.find(kRegularValence);
  const std::size_t singular = edges - (regular == valences.edges.end() ? 0 : regular->second);
  return heading +
         fmt::format("<p>{} of {} interior edges are singular: their valence is not {}.</p>\n",
                     singular, edges, kRegularValence) +
         "<div class=\"tables\">\n" +
         table("", "Interior edges by valence", "hexahedra around", "edges",
               rows_of(valences.edges)) +
         table("", "Interior vertices", "hexahedra around", "vertices",
               rows_of(valences.vertices)) +
         "</div>\n";
}

std::string report_page(const MeshReport& report, const mesh::HexMesh& mesh) {
  const std::string title = escaped(report.title);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" "
      "content=\"default-src 'none'; style-src 'unsafe-inline'\"/>\n"
      "<title>{0}: hexahedral mesh</title>\n<style>{1}</style>\n</head>\n<body>\n"
      "<header>\n<p class=\"over\">Report of a hexahedral mesh</p>\n<h1>{0}</h1>\n</header>\n"
      "<main>\n",
      title, kStyle);
  html += figures(report.qualities.back().quality);
  for (const Account& account : report.accounts) html += section_of(account);
  for (std::size_t i = 0; i < report.qualities.size(); ++i)
    html += section_of(report.qualities[i], i + 1);
  html += section_of(view::interior_valences(mesh, view::neighbours_of(mesh)));
  return html + fmt::format("</main>\n<footer>Made by hexatlas {}.</footer>\n</body>\n</html>\n",
                            version());
}

}  // namespace

void Account::add(std::string label, std::string value) {
  lines.push_back({std::move(label), std::move(value)});
}

void Account::add(std::string label, std::size_t count) {
  add(std::move(label), std::to_string(count));
}

void Account::add_seconds(double seconds) { add("seconds", fmt::format("{:.2f}", seconds)); }

Account judgement(const check::Verdict& verdict) {
  core::expects(verdict.accepted || verdict.undecided, "report: a mesh with a fault");
  Account account{"What the judge says", {}};
  account.add("verdict",
              verdict.accepted ? "accepted" : "accepted but for a proof that it is a ball");
  account.add("ball", verdict.accepted
                          ? "proven by a " + verdict.ball_proof
                          : "by theorem only: the judge found no proof within its limits");
  return account;
}

std::string shown_name(const std::string& path, const char* stream) {
  return path == "-" ? stream : std::filesystem::path(path).filename().string();
}

void write_with_report(const MeshFiles& files, const mesh::HexMesh& mesh,
                       const std::function<MeshReport()>& report_of) {
  std::string page;
  if (!files.report.empty()) page = report_page(report_of(), mesh);
  write_mesh(files.output, mesh);
  if (!files.report.empty()) core::write_file(files.report, page);
}

}  // namespace hexatlas::cli
