// Names of subjects are taken apart for series and labels: "kernel/lambert+ggx/point/64/640x360/portable/16".
#include "bench/plot_scripts.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace relume::bench {
namespace {

std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts;
  std::istringstream in(name);
  for (std::string part; std::getline(in, part, '/');) parts.push_back(part);
  return parts;
}

/// Series of lines of numbers, each a data block of gnuplot's.
class Series {
 public:
  template <class... Values>
  void add(const std::string& series, const Values&... values) {
    std::ostringstream& text = text_[series];
    ((text << values << ' '), ...);
    text << '\n';
  }
  bool empty() const { return text_.empty(); }

  std::string blocks() const {
    std::string all;
    int k = 0;
    for (const auto& [name, text] : text_) all += "$series" + std::to_string(k++) + " << END\n" + text.str() + "END\n";
    return all;
  }
  /// "$series0 using 1:2 with linespoints title 'portable', ..."
  std::string plotted(const std::string& how) const {
    std::string all;
    int k = 0;
    for (const auto& [name, text] : text_) {
      all += (k ? ", " : "") + ("$series" + std::to_string(k)) + " " + how + " lt " + std::to_string(k % 6 + 1) + " title '" + name + "'";
      ++k;
    }
    return all;
  }

 private:
  std::map<std::string, std::ostringstream> text_;
};

/// Roofs of each device, and each kernel below them.
std::vector<Plot> roofline(const Bench& bench) {
  Series points;
  for (const Measurement& m : bench.measurements) {
    const std::vector<std::string> parts = parts_of(m.subject.name);
    if (parts[0] != "kernel" || m.subject.work.bytes <= 0) continue;
    points.add(parts[5] + ", " + parts[6] + " lanes", m.subject.work.flops / m.subject.work.bytes, m.per_second(m.subject.work.flops) / 1e9);
  }
  if (points.empty()) return {};
  std::string roofs;
  int line = 1;
  for (const BenchDevice& d : bench.devices) {
    if (d.limits.fused <= 0) continue;
    std::ostringstream roof;
    const double separate = d.limits.separate > 0 ? d.limits.separate : d.limits.fused;
    roof << "(x*" << d.limits.read / 1e9 << "<" << d.limits.fused / 1e9 << "?x*" << d.limits.read / 1e9 << ":" << d.limits.fused / 1e9 << ") lt "
         << line << " title '" << d.label << ": multiply-add and memory, measured', (x*" << d.limits.read / 1e9 << "<" << separate / 1e9
         << "?1/0:" << separate / 1e9 << ") lt " << line << " dt 2 title '" << d.label << ": in two instructions', ";
    roofs += roof.str();
    ++line;
  }
  return {{"roofline",
           {points.blocks(),
            "set title 'Roofline: useful arithmetic against what memory must move (small frames come from cache)'\nset xlabel 'flop a byte' offset "
            "0,0.5\nset "
            "ylabel 'Gflop/s'\nset logscale xy\n"
            "set xrange [0.1:*]\nset yrange [1:*]\nset samples 500\nset key outside bottom center maxcols 1\nplot " +
                roofs + points.plotted("using 1:2 with points")}}};
}

std::vector<Plot> scaling(const Bench& bench) {
  std::map<std::string, double> one;
  Series lines;
  double most = 1;
  for (const Measurement& m : bench.measurements) {
    const std::vector<std::string> parts = parts_of(m.subject.name);
    if (parts[0] != "scaling") continue;
    const std::string series = parts[1] + ", " + parts[2];
    const double rate = m.per_second(m.subject.work.pairs());
    if (parts[3] == "1") one[series] = rate;
    if (!one.contains(series)) continue;
    lines.add(series, parts[3], rate / one[series]);
    most = std::max(most, std::stod(parts[3]));
  }
  if (lines.empty() || most < 2) return {};
  const std::string end = std::to_string(int(most));
  return {{"scaling",
           {lines.blocks(), "set title 'Scaling over compute units'\nset xlabel 'compute units'\nset ylabel 'rate over that of one'\nset xrange [1:" +
                                end + "]\nset yrange [0:" + end + ".2]\nset xtics 1\nset key left top\nplot x lc rgb '#999999' dt 2 title 'ideal', " +
                                lines.plotted("using 1:2 with linespoints")}}};
}

/// How long a frame takes against the number of lights, where other things are equal.
std::vector<Plot> light_counts(const Bench& bench) {
  std::map<std::string, std::vector<std::pair<int, double>>> all;
  for (const Measurement& m : bench.measurements) {
    const std::vector<std::string> p = parts_of(m.subject.name);
    if (p[0] == "kernel")
      all[p[1] + ", " + p[2] + ", " + p[4] + ", " + p[5] + ", " + p[6] + " lanes"].emplace_back(std::stoi(p[3]), m.median() * 1e3);
  }
  Series lines;
  for (auto& [name, points] : all) {
    if (points.size() < 3) continue;
    std::sort(points.begin(), points.end());
    for (const auto& [lights, milliseconds] : points) lines.add(name, lights, milliseconds);
  }
  if (lines.empty()) return {};
  return {
      {"lights",
       {lines.blocks(),
        "set title 'Time of a frame against the number of lights, brute force'\nset xlabel 'lights' offset 0,0.5\nset ylabel 'ms'\nset logscale xy\n"
        "set key outside bottom center maxcols 1\nplot " +
            lines.plotted("using 1:2 with linespoints")}}};
}

/// A bar for each lobe, fastest first.
std::vector<Plot> lobes(const Bench& bench) {
  std::map<std::string, std::map<std::string, double>> by_setting;
  for (const Measurement& m : bench.measurements) {
    const std::vector<std::string> p = parts_of(m.subject.name);
    if (p[0] == "kernel")
      by_setting[p[2] + ", " + p[3] + " lights, " + p[4] + ", " + p[5] + ", " + p[6] + " lanes"][p[1]] = m.per_second(m.subject.work.pairs()) / 1e6;
  }
  const auto most =
      std::max_element(by_setting.begin(), by_setting.end(), [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  if (most == by_setting.end() || most->second.size() < 3) return {};
  std::vector<std::pair<double, std::string>> bars;
  for (const auto& [pair, rate] : most->second) bars.emplace_back(rate, pair);
  std::sort(bars.begin(), bars.end());
  std::ostringstream data;
  data << "$bars << END\n";
  for (std::size_t k = 0; k < bars.size(); ++k) data << k << ' ' << bars[k].first << " \"" << bars[k].second << "\"\n";
  data << "END\n";
  return {{"lobes",
           {data.str(),
            "set title 'Lobes: " + most->first +
                "'\nset xlabel 'million pixel*lights/s'\nunset ylabel\nunset key\nset xrange [0:*]\nset yrange [-0.7:" + std::to_string(bars.size()) +
                "]\nset style fill solid\nset boxwidth 0.7\n" +
                "plot $bars using ($2/2):1:($2/2):(0.35):ytic(3) with boxxyerror lt 1 notitle, $bars using 2:1:(sprintf(' %.0f', $2)) with labels "
                "left notitle",
            900, int(120 + 22 * bars.size())}}};
}

/// Relume beside plain C++ and the textbook kernels; rates differ by orders of magnitude.
std::vector<Plot> yardsticks(const Bench& bench) {
  std::map<std::string, std::vector<std::pair<std::string, double>>> by_who;
  std::vector<std::string> brdfs;
  for (const Measurement& m : bench.measurements) {
    const std::vector<std::string> p = parts_of(m.subject.name);
    if (p[0] != "yardstick") continue;
    if (std::find(brdfs.begin(), brdfs.end(), p[1]) == brdfs.end()) brdfs.push_back(p[1]);
    by_who[p[2] + (p.size() > 3 ? ", " + p[3] : "")].emplace_back(p[1], m.per_second(m.subject.work.pairs()) / 1e6);
  }
  if (by_who.empty()) return {};
  std::ostringstream data;
  std::string plotted;
  int k = 0;
  for (const auto& [who, rates] : by_who) {
    data << "$who" << k << " << END\n";
    for (const auto& [brdf, rate] : rates)
      data << double(std::find(brdfs.begin(), brdfs.end(), brdf) - brdfs.begin()) * (double(by_who.size()) + 1.5) + k << ' ' << rate << '\n';
    data << "END\n";
    plotted += (k ? ", " : "") + ("$who" + std::to_string(k)) + " using 1:2 with boxes lt " + std::to_string(k % 6 + 1) + " title '" + who +
               "', $who" + std::to_string(k) + " using 1:2:(sprintf($2 < 100 ? '%.3g' : '%.0f', $2)) with labels offset 0,0.6 font ',9' notitle";
    ++k;
  }
  std::string tics;
  for (std::size_t b = 0; b < brdfs.size(); ++b)
    tics += (b ? ", '" : "'") + brdfs[b] + "' " + std::to_string(double(b) * (double(by_who.size()) + 1.5) + double(by_who.size() - 1) / 2);
  return {{"yardsticks",
           {data.str(),
            "set title 'Relume beside its yardsticks, 64 unranged point lights'\nset ylabel 'million pixel*lights/s'\nunset xlabel\nset logscale "
            "y\nset style fill solid\n"
            "set boxwidth 0.9\nset xtics (" +
                tics + ")\nset rmargin 32\nset key outside right top\nplot " + plotted,
            1100, 560}}};
}

}  // namespace

std::vector<Plot> plots_of(const Bench& bench) {
  std::vector<Plot> all;
  for (const auto make : {roofline, scaling, light_counts, lobes, yardsticks})
    for (Plot& plot : make(bench)) all.push_back(std::move(plot));
  return all;
}

}  // namespace relume::bench
