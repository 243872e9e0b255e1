// The table's columns and the CSV's; JSON is in report_json.cpp.
#include "bench/report.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "gbuffer/printable.h"
#include "gbuffer/whole_file.h"

namespace relume::bench {
namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// Three digits and a prefix: "558 M".
std::string scaled(double value) {
  const char* prefixes[] = {"", " k", " M", " G", " T"};
  int p = 0;
  while (value >= 999.5 && p < 4) value /= 1000, ++p;
  return formatted(value < 9.995 ? "%.2f%s" : value < 99.95 ? "%.1f%s" : "%.0f%s", value, prefixes[p]);
}

std::string time_of(double seconds) {
  if (seconds < 1e-3) return formatted("%.3g us", seconds * 1e6);
  return formatted(seconds < 1 ? "%.4g ms" : "%.4g s", seconds < 1 ? seconds * 1e3 : seconds);
}

std::string or_dash(double value) { return value > 0 ? scaled(value) : "-"; }

}  // namespace

void print_header(std::ostream& out, const Bench& bench) {
  for (const BenchDevice& d : bench.devices) {
    const DeviceInfo& info = d.info;
    out << d.label << ": " << printable(info.name) << " (" << printable(info.platform) << ", " << printable(info.version) << "), " << info.lanes
        << " lanes\n";
    if (d.is_twin()) continue;
    out << "  multiply-add " << scaled(d.limits.fused) << "flop/s, in two instructions " << scaled(d.limits.separate) << "flop/s; read "
        << scaled(d.limits.read) << "B/s, copy " << scaled(d.limits.copy) << "B/s, triad " << scaled(d.limits.triad) << "B/s; launch "
        << time_of(d.limits.launch) << "\n";
  }
  if (double load[1]; getloadavg(load, 1) == 1 && load[0] > 0.5)
    out << formatted("load %.1f on %u processors: others run beside this, which ratios in processor time stand best\n", load[0],
                     std::thread::hardware_concurrency());
  out << "cpp: multiply-add " << scaled(bench.processor.fused) << "flop/s on all threads, " << scaled(bench.one_thread.fused)
      << "flop/s on one; read " << scaled(bench.processor.read) << "B/s, copy " << scaled(bench.processor.copy) << "B/s, triad "
      << scaled(bench.processor.triad) << "B/s\n\n";
  out << formatted("%-58s %10s %10s %7s %11s %-7s %7s %7s %6s  %s\n", "", "min", "median", "n", "pixel*lights/s", "", "flop/s", "B/s", "peak",
                   "image against the twin");
}

void print_row(std::ostream& out, const Measurement& m) {
  const Work& work = m.subject.work;
  const double flops = m.per_second(work.flops), peak = m.subject.roof.flops;
  const std::string share = flops > 0 && peak > 0 ? formatted("%.1f%%", 100 * flops / peak) : "-";
  out << formatted("%-58s %10s %10s %7s %11s %-7s %7s %7s %6s  %s\n", m.subject.name.c_str(), time_of(m.least()).c_str(), time_of(m.median()).c_str(),
                   (std::to_string(m.seconds.size()) + "x" + std::to_string(m.goes)).c_str(), or_dash(m.per_second(work.pairs())).c_str(),
                   work.pixel_lights.empty() ? "" : work.pixel_lights.front().counted.c_str(), or_dash(flops).c_str(),
                   or_dash(m.per_second(work.bytes)).c_str(), share.c_str(), m.subject.verdict.empty() ? "-" : m.subject.verdict.c_str());
  for (std::size_t k = 1; k < work.pixel_lights.size(); ++k)
    out << formatted("%-88s %11s %s\n", "", scaled(m.per_second(work.pixel_lights[k].pairs)).c_str(), work.pixel_lights[k].counted.c_str());
  out << std::flush;
}

void print_weighed(std::ostream& out, const Weighed& w) {
  const bool is_time = w.claim.measure == Measure::milliseconds, is_share = w.claim.measure == Measure::peak_share;
  const double scale = is_share ? 100 : 1;
  const char* unit = is_time ? " ms" : is_share ? "%" : "";
  out << formatted("  %s %s: %.2f%s (quartiles %.2f .. %.2f; in processor time %.2f)", w.claim.subject.c_str(), w.claim.sentence.c_str(),
                   w.median * scale, unit, w.low * scale, w.high * scale, w.processor * scale);
  const bool at_least = w.claim.measure == Measure::rate_over || is_share;
  if (w.claim.goal > 0)
    out << formatted(", asked: %s %g%s, %s", at_least ? "at least" : "at most", w.claim.goal * scale, unit, w.met() ? "met" : "not met");
  out << "\n" << std::flush;
}

void write_csv(const std::filesystem::path& file, const Bench& bench) {
  std::ostringstream text;
  text.precision(9);
  text << "name,min_seconds,median_seconds,rounds,goes,cpu_seconds,pixel_lights_per_second,counted,flop_per_second,bytes_per_second,share_of_peak,"
          "image\n";
  for (const Measurement& m : bench.measurements) {
    const Work& work = m.subject.work;
    const double flops = m.per_second(work.flops);
    text << m.subject.name << ',' << m.least() << ',' << m.median() << ',' << m.seconds.size() << ',' << m.goes << ',' << quantile(m.cpu_seconds, 0.5)
         << ',' << m.per_second(work.pairs()) << ',' << (work.pixel_lights.empty() ? "" : work.pixel_lights.front().counted) << ',' << flops << ','
         << m.per_second(work.bytes) << ',' << (m.subject.roof.flops > 0 ? flops / m.subject.roof.flops : 0) << ',' << m.subject.verdict << '\n';
  }
  write_whole(file, text.str(), true);
}

}  // namespace relume::bench
