#include "tables/sheet/contact_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <vector>

#include "enum/core/words.hpp"
#include "tables/sheet/contact_sheet_style.hpp"
#include "tables/sheet/contact_sheet_svg.hpp"

namespace hexatlas::sheet {
namespace {

using core::counted;

using certificate::Condition;
using certificate::kConditions;
using format::Catalogue;
using format::CatalogueClass;

enum class Status : std::uint8_t { yes, refuted, open, unasked };
constexpr std::array<Status, 4> kStatuses{Status::yes, Status::refuted, Status::open,
                                          Status::unasked};
struct StatusWords {
  std::string_view key, word, sign;
};
StatusWords words_of(Status status) {
  static constexpr std::array<StatusWords, 4> kWords{{{"yes", "yes", "✓"},
                                                      {"refuted", "no", "✗"},
                                                      {"open", "open", "?"},
                                                      {"unasked", "not asked", "–"}}};
  return kWords[static_cast<std::size_t>(status)];
}

struct ConditionWords {
  std::string_view badge, full;
};
ConditionWords words_of(Condition condition) {
  static constexpr std::array<ConditionWords, kConditions.size()> kWords{
      {{"realizable", "realizable"},
       {"convex", "realizable in convex position"},
       {"Jacobian", "realizable with positive Jacobian"}}};
  return kWords[static_cast<std::size_t>(condition)];
}

const std::optional<certificate::Answer>& answer_of(const CatalogueClass& entry,
                                                    Condition condition) {
  return entry.answers[static_cast<std::size_t>(condition)];
}

Status status_of(const CatalogueClass& entry, Condition condition) {
  const auto& answer = answer_of(entry, condition);
  if (!answer) return Status::unasked;
  if (std::holds_alternative<certificate::Realization>(*answer)) return Status::yes;
  return std::holds_alternative<certificate::Refutation>(*answer) ? Status::refuted : Status::open;
}

const certificate::Realization* points_of(const CatalogueClass& entry) {
  for (const Condition condition : {Condition::convex, Condition::jacobian, Condition::embedded})
    if (const auto& answer = answer_of(entry, condition))
      if (const auto* points = std::get_if<certificate::Realization>(&*answer)) return points;
  return nullptr;
}

/// Indices of classes by number of tetrahedra.
using Groups = std::map<std::size_t, std::vector<std::size_t>>;

Groups groups_of(const Catalogue& catalogue) {
  Groups groups;
  for (std::size_t i = 0; i < catalogue.classes.size(); ++i)
    groups[catalogue.classes[i].triangulation.tetrahedra.size()].push_back(i);
  return groups;
}

std::size_t number_with(const Catalogue& catalogue, const std::vector<std::size_t>& members,
                        Condition condition, Status status) {
  return static_cast<std::size_t>(std::count_if(members.begin(), members.end(), [&](std::size_t i) {
    return status_of(catalogue.classes[i], condition) == status;
  }));
}

std::string heading(const Catalogue& catalogue) {
  if (!catalogue.cell) return fmt::format("Balls of tetrahedra on {} vertices", catalogue.vertices);
  std::string text = "Triangulations of the " + catalogue.name;
  if (catalogue.interior > 0)
    text += " with " + counted(static_cast<std::size_t>(catalogue.interior), "interior vertex",
                               "interior vertices");
  return text;
}

std::string lead(const Catalogue& catalogue) {
  std::string text = catalogue.exhaustive ? "" : "At least ";
  text += counted(catalogue.classes.size(), "class", "classes");
  if (catalogue.cell)
    text += fmt::format(", {} labelled triangulations; {} of the cell", catalogue.labelled,
                        counted(catalogue.symmetries, "symmetry", "symmetries"));
  if (catalogue.boundary_tetrahedra) text += "; boundary tetrahedra allowed";
  return text + (catalogue.exhaustive ? ". The list is complete." : ". The list may go on.");
}

std::string totals(const Catalogue& catalogue, const std::vector<std::size_t>& all) {
  std::string text =
      "<table><thead><tr><th scope=\"col\">classes that are</th><th scope=\"col\">✓ yes</th>"
      "<th scope=\"col\">✗ no</th><th scope=\"col\">? open</th>"
      "<th scope=\"col\">– not asked</th></tr></thead><tbody>\n";
  for (const Condition condition : kConditions) {
    text += fmt::format("<tr><th scope=\"row\">{}</th>", words_of(condition).full);
    for (const Status status : kStatuses)
      text += fmt::format("<td>{}</td>", number_with(catalogue, all, condition, status));
    text += "</tr>\n";
  }
  return text + "</tbody></table>\n";
}

/// A column of bars for one number of tetrahedra: one bar per condition, its parts by status.
std::string column(const Catalogue& catalogue, const std::vector<std::size_t>& members, double x,
                   double base, double scale) {
  constexpr std::array<std::string_view, 4> kStyles{"yes", "no", "open", "unasked"};
  std::string text;
  for (const Condition condition : kConditions) {
    double y = base;
    for (const Status status : kStatuses) {
      const std::size_t number = number_with(catalogue, members, condition, status);
      if (number == 0) continue;
      const double height = scale * static_cast<double>(number);
      y -= height;
      text += fmt::format(
          "<rect class=\"bar-{}\" x=\"{}\" y=\"{}\" width=\"12\" height=\"{}\"><title>{}: {} of {} "
          "{}</title></rect>",
          kStyles[static_cast<std::size_t>(status)], decimal(x), decimal(y), decimal(height),
          words_of(condition).full, number, members.size(), words_of(status).word);
    }
    text += fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">{}</text>", decimal(x + 6),
                        decimal(base + 10), words_of(condition).badge.substr(0, 1));
    x += 14;
  }
  return text;
}

std::string histogram(const Catalogue& catalogue, const Groups& groups) {
  constexpr double kStep = 58, kBase = 150, kTop = 130;
  std::size_t most = 1;
  for (const auto& [t, members] : groups) most = std::max(most, members.size());
  const double scale = kTop / static_cast<double>(most);
  const double width = kStep * static_cast<double>(std::max<std::size_t>(groups.size(), 4));
  std::string text = fmt::format(
      "<svg class=\"histogram\" viewBox=\"0 0 {} 196\" role=\"img\"><title>Classes by number of "
      "tetrahedra</title><desc>",
      decimal(width));
  for (const auto& [t, members] : groups)
    text += fmt::format("{} tetrahedra: {}. ", t, counted(members.size(), "class", "classes"));
  text +=
      "</desc><defs><pattern id=\"hatch\" width=\"4\" height=\"4\" "
      "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><path class=\"hatch\" "
      "d=\"M0 0L0 4\"/></pattern></defs>\n";
  double x = 0;
  for (const auto& [t, members] : groups) {
    const double top = kBase - scale * static_cast<double>(members.size());
    text += fmt::format("<a href=\"#t{}\">", t) + column(catalogue, members, x + 9, kBase, scale);
    text += fmt::format(
        "<text x=\"{0}\" y=\"{1}\">{2}</text><text x=\"{0}\" y=\"{3}\">{4}</text></a>\n",
        decimal(x + kStep / 2), decimal(top - 5), members.size(), decimal(kBase + 26), t);
    x += kStep;
  }
  return text +
         fmt::format(
             "<path class=\"axis\" d=\"M0 {0}L{1} {0}\"/><text class=\"small start\" x=\"0\" "
             "y=\"{2}\">number of tetrahedra; bars: r realizable, c convex, J positive "
             "Jacobian</text></svg>\n",
             decimal(kBase), decimal(width), decimal(kBase + 43));
}

std::string key(const Catalogue& catalogue) {
  std::string text = "<div class=\"key\"><span>Triangles of a tetrahedron on the boundary:</span>";
  for (int number = 0; number < 4; ++number)
    text += fmt::format(
        "<span><svg viewBox=\"0 0 12 12\" aria-hidden=\"true\"><polygon class=\"d{0}\" points=\"6 "
        "0 "
        "12 12 0 12\"/></svg>{0}</span>",
        number);
  text +=
      "<p>The tetrahedra are moved apart from the centre, after a deformation "
      "that brings the points close to a regular shape and turns over or overlaps no "
      "tetrahedra. Bold: edges of the ";
  text += catalogue.cell ? "cell" : "boundary";
  text +=
      ", left in place. A class without coordinates is shown by its graph: nodes are the "
      "tetrahedra, lines common triangles";
  if (catalogue.cell) text += ", dashed lines the two halves of a quad";
  return text + ".</p></div>\n";
}

std::string filter(std::size_t classes) {
  std::string text = "<form hidden=\"hidden\">";
  for (const Condition condition : kConditions) {
    text += fmt::format("<label>{} <select name=\"{}\"><option value=\"any\">any</option>",
                        words_of(condition).badge, certificate::name_of(condition));
    for (const Status status : kStatuses)
      text += fmt::format("<option value=\"{}\">{}</option>", words_of(status).key,
                          words_of(status).word);
    text += "</select></label>";
  }
  return text + fmt::format("<output>{} shown</output></form>\n", classes);
}

std::string badges(const CatalogueClass& entry) {
  std::string text = "<ul class=\"badges\">";
  for (const Condition condition : kConditions) {
    const StatusWords status = words_of(status_of(entry, condition));
    const ConditionWords words = words_of(condition);
    const std::string_view strike = status.key == "refuted" ? "s" : "span";
    text += fmt::format(
        "<li class=\"{0}\" title=\"{1}: {2}\" aria-label=\"{1}: {2}\">{3} <{4}>{5}"
        "</{4}></li>",
        status.key, words.full, status.word, status.sign, strike, words.badge);
  }
  return text + "</ul>";
}

std::string drawing(const Catalogue& catalogue, const CatalogueClass& entry,
                    const std::optional<Frame>& frame) {
  if (const auto* points = points_of(entry)) {
    const Frame own = frame ? *frame : frame_of(entry.triangulation);
    return exploded_drawing(own, entry.triangulation, *points);
  }
  const bool is_refuted = status_of(entry, Condition::embedded) == Status::refuted;
  return graph_drawing(entry.triangulation, catalogue.cell) +
         fmt::format("<text class=\"note{}\" x=\"{}\" y=\"{}\">{}</text>",
                     is_refuted ? "" : " plain", decimal(kTileWidth / 2), decimal(kTileHeight - 3),
                     is_refuted ? "not realizable" : "no coordinates");
}

std::string tile(const Catalogue& catalogue, std::size_t index, const std::optional<Frame>& frame) {
  const CatalogueClass& entry = catalogue.classes[index];
  std::string tetrahedra;
  for (const complex::VertexSet t : entry.triangulation.tetrahedra)
    tetrahedra += (tetrahedra.empty() ? "" : " ") + digits_of(t);
  const std::string number =
      counted(entry.triangulation.tetrahedra.size(), "tetrahedron", "tetrahedra");
  std::string text = fmt::format("<figure class=\"tile\" id=\"class-{}\"", index + 1);
  for (const Condition condition : kConditions)
    text += fmt::format(" data-{}=\"{}\"", certificate::name_of(condition),
                        words_of(status_of(entry, condition)).key);
  text += fmt::format("><figcaption><a href=\"#class-{0}\">{0}</a><span>{1}", index + 1, number);
  if (catalogue.cell) text += fmt::format(" · size {}", catalogue.symmetries / entry.automorphisms);
  text += fmt::format(" · {} aut.</span></figcaption>\n", entry.automorphisms);
  text += fmt::format(
      "<svg viewBox=\"0 0 {} {}\" role=\"img\"><title>Class {}</title><desc>{}: {}</desc>",
      decimal(kTileWidth), decimal(kTileHeight), index + 1, number, tetrahedra);
  text += drawing(catalogue, entry, frame) + "</svg>\n<p class=\"tetrahedra\">" + tetrahedra;
  return text + "</p>" + badges(entry) + "</figure>\n";
}

std::string section(const Catalogue& catalogue, std::size_t tetrahedra,
                    const std::vector<std::size_t>& members, const std::optional<Frame>& frame) {
  std::uint64_t labelled = 0;
  for (const std::size_t i : members)
    labelled += catalogue.symmetries / catalogue.classes[i].automorphisms;
  std::string text = fmt::format("<section id=\"t{}\"><h2>{} <small>{}", tetrahedra,
                                 counted(tetrahedra, "tetrahedron", "tetrahedra"),
                                 counted(members.size(), "class", "classes"));
  if (catalogue.cell) text += fmt::format(", {} labelled", labelled);
  text += "</small></h2><div class=\"tiles\">\n";
  for (const std::size_t i : members) text += tile(catalogue, i, frame);
  return text + "</div></section>\n";
}

}  // namespace

std::string contact_sheet(const Catalogue& catalogue) {
  const Groups groups = groups_of(catalogue);
  std::vector<std::size_t> all;
  for (const auto& [t, members] : groups) all.insert(all.end(), members.begin(), members.end());
  const std::string title = heading(catalogue);
  std::optional<Frame> frame;
  if (catalogue.cell) frame = frame_of(*catalogue.cell);

  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\"><head>"
      "<meta charset=\"utf-8\"/><meta name=\"viewport\" content=\"width=device-width\"/>"
      "<title>{}</title>\n<style>",
      title);
  text += page_style();
  text +=
      colour_rules() + "</style></head><body>\n<header><h1>" + title + "</h1><p class=\"lead\">";
  text += lead(catalogue) + "</p>\n<div class=\"front\">" + histogram(catalogue, groups);
  text += totals(catalogue, all) + "</div>\n" + key(catalogue) + filter(all.size());
  text += "</header>\n<main>\n";
  for (const auto& [t, members] : groups) text += section(catalogue, t, members, frame);
  text += "</main>\n<script>";
  text += page_script();
  return text + "</script></body></html>\n";
}

}  // namespace hexatlas::sheet
