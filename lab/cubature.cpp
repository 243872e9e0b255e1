// integrate: rounds in which every integral that is not yet good enough halves its worst rectangles, and one call evaluates all new ones.
#include "lab/cubature.h"

#include <algorithm>
#include <cmath>

namespace relume {
namespace {

// Genz and Malik's rule of degree 7 in two dimensions, with the rule of degree 5 on the same points: places on -1..1 and weights whose sum is 1.
const double kNear = std::sqrt(9.0 / 70), kFar = std::sqrt(9.0 / 10), kDiagonal = std::sqrt(9.0 / 19);
const std::array<glm::dvec2, 17> kPlaces{{{0, 0},
                                          {-kNear, 0},
                                          {kNear, 0},
                                          {0, -kNear},
                                          {0, kNear},
                                          {-kFar, 0},
                                          {kFar, 0},
                                          {0, -kFar},
                                          {0, kFar},
                                          {-kFar, -kFar},
                                          {kFar, -kFar},
                                          {-kFar, kFar},
                                          {kFar, kFar},
                                          {-kDiagonal, -kDiagonal},
                                          {kDiagonal, -kDiagonal},
                                          {-kDiagonal, kDiagonal},
                                          {kDiagonal, kDiagonal}}};
/// Of the centre, then of each four places.
constexpr std::array kDegree7{-3816.0 / 19683, 980.0 / 6561, 1020.0 / 19683, 200.0 / 19683, 6859.0 / 78732};
constexpr std::array kDegree5{-971.0 / 729, 245.0 / 486, 65.0 / 1458, 25.0 / 729, 0.0};
constexpr std::size_t most_points = 1 << 18;

struct Cell {
  std::size_t integral;
  Rectangle where;
  Values value{}, error{};
  double worst = 0;      ///< the greatest error
  bool split_x = false;  ///< whether the integrand bends more along x
};

void add_points(const Cell& cell, std::vector<CubaturePoint>& points) {
  const glm::dvec2 centre = 0.5 * (cell.where.low + cell.where.high), half = 0.5 * (cell.where.high - cell.where.low);
  for (const glm::dvec2& place : kPlaces) points.push_back({cell.integral, centre + half * place});
}

/// Fourth difference along the axis whose near places are f[first], f[first + 1]: what a rule of degree 3 would miss.
double bend(std::span<const Values> f, std::size_t first, std::size_t k) {
  const double near = f[first][k] + f[first + 1][k] - 2 * f[0][k], far = f[first + 4][k] + f[first + 5][k] - 2 * f[0][k];
  return std::abs(near - far / 7);  // the places' squares are as 1 to 7
}

/// From the integrand at the cell's places.
void apply_rule(std::span<const Values> f, Cell& cell) {
  const glm::dvec2 size = cell.where.high - cell.where.low;
  const double area = size.x * size.y;
  double bend_x = 0, bend_y = 0;
  for (std::size_t k = 0; k < cell.value.size(); ++k) {
    double seven = kDegree7[0] * f[0][k], five = kDegree5[0] * f[0][k];
    for (std::size_t i = 1; i < kPlaces.size(); ++i) {
      seven += kDegree7[1 + (i - 1) / 4] * f[i][k];
      five += kDegree5[1 + (i - 1) / 4] * f[i][k];
    }
    cell.value[k] = area * seven;
    cell.error[k] = area * std::abs(seven - five);
    cell.worst = std::max(cell.worst, cell.error[k]);
    bend_x += bend(f, 1, k);
    bend_y += bend(f, 3, k);
  }
  // Where it bends alike, or not at all, the longer side.
  cell.split_x = std::abs(bend_x - bend_y) > 1e-6 * (bend_x + bend_y) ? bend_x > bend_y : size.x > size.y;
}

void evaluate(std::span<Cell> cells, const Integrand& integrand) {
  std::vector<CubaturePoint> points;
  points.reserve(cells.size() * kPlaces.size());
  for (const Cell& cell : cells) add_points(cell, points);
  const std::vector<Values> values = integrand(points);
  for (std::size_t i = 0; i < cells.size(); ++i) apply_rule(std::span(values).subspan(i * kPlaces.size(), kPlaces.size()), cells[i]);
}

std::array<Cell, 2> halves(const Cell& cell) {
  std::array<Cell, 2> two{Cell{cell.integral, cell.where}, Cell{cell.integral, cell.where}};
  const int axis = cell.split_x ? 0 : 1;
  two[0].where.high[axis] = two[1].where.low[axis] = 0.5 * (cell.where.low[axis] + cell.where.high[axis]);
  return two;
}

/// Takes the worst cells out of `cells`, as many as leave less than half of the tolerance behind; none where all are below it.
std::vector<Cell> take_worst(std::vector<Cell>& cells, double tolerance) {
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.worst < b.worst; });
  double behind = 0, all = 0;
  for (const Cell& cell : cells) all += cell.worst;
  if (!(all > tolerance)) return {};
  const auto first = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) { return (behind += cell.worst) > 0.5 * tolerance; });
  std::vector<Cell> taken(first, cells.end());
  cells.erase(first, cells.end());
  return taken;
}

Integral sum_of(std::span<const Cell> cells) {
  Integral sum;
  for (const Cell& cell : cells)
    for (std::size_t k = 0; k < sum.value.size(); ++k) {
      sum.value[k] += cell.value[k];
      sum.error[k] += cell.error[k];
    }
  return sum;
}

}  // namespace

std::vector<Integral> integrate(std::span<const std::vector<Rectangle>> domains, const Integrand& integrand, double tolerance) {
  std::vector<std::vector<Cell>> cells(domains.size());
  std::vector<std::size_t> asked(domains.size());
  std::vector<Cell> fresh;
  for (std::size_t i = 0; i < domains.size(); ++i)
    for (const Rectangle& where : domains[i]) fresh.push_back({i, where});
  while (!fresh.empty()) {
    evaluate(fresh, integrand);
    for (const Cell& cell : fresh) {
      cells[cell.integral].push_back(cell);
      asked[cell.integral] += kPlaces.size();
    }
    fresh.clear();
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (asked[i] < most_points)
        for (const Cell& cell : take_worst(cells[i], tolerance))
          for (const Cell& half : halves(cell)) fresh.push_back(half);
  }
  std::vector<Integral> integrals;
  for (const std::vector<Cell>& of_one : cells) integrals.push_back(sum_of(of_one));
  return integrals;
}

}  // namespace relume
