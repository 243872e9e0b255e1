// table_text, albedo_csv and furnace_figure.
#include "lab/plausibility_report.h"

#include <algorithm>
#include <cstdio>

#include "lab/furnace.h"

namespace relume {
namespace {

template <class... Values>
std::string printed(const char* format, const Values&... values) {
  char text[1024];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

const LawFinding* finding_of(const std::vector<LawFinding>& findings, const std::string& law) {
  const auto found = std::find_if(findings.begin(), findings.end(), [&](const LawFinding& f) { return f.law == law; });
  return found == findings.end() ? nullptr : &*found;
}

const char* verdict(const LawFinding& f) { return f.fails() ? "FAILS" : f.holds() ? "yes" : "no"; }

/// The laws beyond the first three.
std::string pins_of(const std::vector<LawFinding>& findings) {
  std::string text;
  for (const LawFinding& f : findings)
    if (f.law != "positive" && f.law != "reciprocal" && f.law != "conserving")
      text += (text.empty() ? "" : ", ") + f.law + (f.fails() ? " FAILS" : "");
  return text;
}

/// "by 5.28", or for what is apart by a share how many times.
std::string amount(const LawFinding& f) {
  const double by = f.deviation.by;
  if (f.law == "reciprocal" && by < 1) return printed("%.3g times as much one way as the other", 1 / (1 - by));
  if (f.law == "reciprocal") return "any number of times as much one way as the other";
  if (f.law == "conserving") return printed("reflects %.4g times what arrives", 1 + by);
  return printed("by %.3g, %.3g is allowed", by, f.limit);
}

std::string explained(const std::vector<LawFinding>& findings, bool claimed) {
  std::string text;
  for (const LawFinding& f : findings)
    if (!f.holds() && f.claimed == claimed)
      text += "  " + f.subject + ": not " + f.law + ": " + amount(f) + "\n      at " + f.deviation.where + "\n      (" + f.meaning + ")\n";
  return text;
}

std::string row_of(const LobeFindings& e) {
  const FurnaceRange range = range_of(e.lobe.furnace);
  std::string row = printed("%-31s %6.4f..%6.4f ", e.lobe.full_name().c_str(), range.least, range.greatest);
  for (const char* law : {"positive", "reciprocal", "conserving"})
    if (const LawFinding* f = finding_of(e.findings, law)) row += printed(" %-10s", verdict(*f));
  return row + " " + pins_of(e.findings) + "\n";
}

}  // namespace

FurnaceRange range_of(const std::vector<FurnaceRow>& furnace) {
  FurnaceRange range;
  bool first = true;
  for (const FurnaceRow& row : furnace)
    for (std::size_t i = 0; i < row.albedo.size(); ++i) {
      range.error = std::max(range.error, row.error[i]);
      if (first || row.albedo[i] < range.least) {
        range.least = row.albedo[i];
        range.least_at = place_of(row, i);
      }
      if (first || row.albedo[i] > range.greatest) {
        range.greatest = row.albedo[i];
        range.greatest_at = place_of(row, i);
      }
      first = false;
    }
  return range;
}

std::string table_text(const std::vector<LobeFindings>& lobes, const std::vector<LawFinding>& terms) {
  std::string text = printed("%-31s %-15s  %-10s %-10s %-10s %s\n", "BRDF", "white furnace", "positive", "reciprocal", "conserving", "pinned by");
  std::string broken, failed;
  for (const LobeFindings& e : lobes) {
    text += row_of(e);
    broken += explained(e.findings, false);
    failed += explained(e.findings, true);
  }
  for (const LawFinding& f : terms)
    text += printed("%-42s %-14s %-6s off by %.2g (%s)\n", f.subject.c_str(), f.law.c_str(), verdict(f), f.deviation.by, f.meaning.c_str());
  failed += explained(terms, true);
  if (!broken.empty()) text += "\nNot kept, and not claimed:\n" + broken;
  if (!failed.empty()) text += "\nFAILS: claimed, and not kept:\n" + failed;
  return text;
}

std::string albedo_csv(const std::vector<LobeFindings>& lobes) {
  std::string text = "half,brdf,setting,view_degrees,albedo,error\n";
  for (const LobeFindings& e : lobes)
    for (const FurnaceRow& row : e.lobe.furnace)
      for (std::size_t i = 0; i < row.albedo.size(); ++i)
        text += printed("%s,%s,%s,%g,%.9g,%.2g\n", e.lobe.diffuse ? "diffuse" : "specular", e.lobe.name.c_str(), text_of(row.setting).c_str(),
                        furnace_angles[i], row.albedo[i], row.error[i]);
  return text;
}

Figure furnace_figure(const std::vector<LobeFindings>& lobes) {
  Figure figure;
  std::string rows, names;
  int place = int(lobes.size());
  double most = 1;
  for (const LobeFindings& e : lobes) {
    const FurnaceRange range = range_of(e.lobe.furnace);
    const LawFinding* conserving = finding_of(e.findings, "conserving");
    most = std::max(most, range.greatest);
    rows += printed("%d %.6g %.6g %d %.4g\n", place, range.least, range.greatest, conserving && conserving->holds() ? 1 : 2, range.greatest);
    names += printed("%s\"%s\" %d", names.empty() ? "" : ", ", e.lobe.full_name().c_str(), place--);
  }
  figure.data = "$ranges << END\n" + rows + "END\n";
  figure.height = 180 + 26 * int(lobes.size());
  figure.commands =
      "set title 'White furnace: directional albedo over all angles and parameters'\n"
      "set lmargin 31\nset bmargin 6\nset xrange [0:" +
      printed("%g", most * 1.15) + "]\nset xlabel 'share of light reflected, every reflectance 1; the number: the greatest'\nset yrange [0.3:" +
      printed("%g", double(lobes.size()) + 0.7) + "]\nset ytics (" + names +
      ")\nset key bmargin center horizontal\n"
      "set arrow 1 from 1, graph 0 to 1, graph 1 nohead lw 1.5 lc rgb '#000000' dt 2\n"
      "of(wanted, verdict, place) = verdict == wanted ? place : 1/0\n"
      "plot $ranges using 2:(of(1, $4, $1)):($3-$2):(0) with vectors nohead lw 6 lt 1 title 'conserving', "
      "$ranges using 2:(of(2, $4, $1)):($3-$2):(0) with vectors nohead lw 6 lt 2 title 'not conserving', "
      "$ranges using 3:(of(1, $4, $1)) with points pt 7 ps 1 lt 1 notitle, $ranges using 3:(of(2, $4, $1)) with points pt 7 ps 1 lt 2 notitle, "
      "$ranges using 3:1:5 with labels left offset 1,0 notitle\n";
  return figure;
}

}  // namespace relume
