// kernels/language.h spelt a third time: one lane whose every operation is written down. Two operations on the same operands are one (a compiler
// finds that too), those on constants alone are none, and what no stored result and no branch needs is not counted.
// Included by operations.cpp alone, inside its namespace, before the kernels.
#define RELUME_LANGUAGE_H
#define RELUME_LANES 1
#define RELUME_FN [[maybe_unused]] static inline
#define RELUME_GLOBAL
#define RELUME_LIGHT

enum class Kind { constant, load, add, multiply, fused, divide, root, compare, select, whole, free };

struct Node {
  Kind kind;
  std::array<std::int64_t, 3> operands;  ///< nodes; of a constant its bits, of a load its address
  auto operator<=>(const Node&) const = default;
};

/// What was computed so far.
struct Tape {
  std::vector<Node> nodes;
  std::map<Node, int> known;
  std::vector<int> stored, decided;  ///< decided: upon which way the program goes

  int write(Kind kind, std::array<std::int64_t, 3> operands) {
    const auto [at, is_new] = known.try_emplace({kind, operands}, int(nodes.size()));
    if (is_new) nodes.push_back(at->first);
    return at->second;
  }
};
inline Tape tape;

template <class T>
struct Noted {
  T value{};
  int node = -1;

  Noted() = default;
  Noted(T constant) : value(constant), node(tape.write(Kind::constant, {std::int64_t(std::bit_cast<std::int32_t>(constant)), sizeof(T), 0})) {}
  Noted(T result, Kind kind, std::array<std::int64_t, 3> operands) : value(result), node(tape.write(kind, operands)) {}
};
using real = Noted<float>;
using integer = Noted<int>;
using mask = integer;

/// The result of an operation; of constants, a constant. `variant` tells apart what the kind does not.
template <class T, class A, class B = A>
Noted<T> noted(T result, Kind kind, int variant, const Noted<A>& a, const Noted<B>& b) {
  const auto is_constant = [](int node) { return tape.nodes[std::size_t(node)].kind == Kind::constant; };
  if (is_constant(a.node) && is_constant(b.node)) return Noted<T>(result);
  return Noted<T>(result, kind, {a.node, b.node, variant});
}
template <class T, class A>
Noted<T> noted(T result, Kind kind, int variant, const Noted<A>& a) {
  return noted(result, kind, variant, a, a);
}

/// What is multiplied by 0 is a lobe that is not there, and so is what adds 0.
inline bool is_zero(const real& x) { return x.value == 0 && tape.nodes[std::size_t(x.node)].kind == Kind::constant; }

inline real operator+(real a, real b) { return is_zero(a) ? b : is_zero(b) ? a : noted(a.value + b.value, Kind::add, 0, a, b); }
inline real operator-(real a, real b) { return noted(a.value - b.value, Kind::add, 1, a, b); }
inline real operator*(real a, real b) { return is_zero(a) || is_zero(b) ? real(0.0f) : noted(a.value * b.value, Kind::multiply, 0, a, b); }
inline real operator/(real a, real b) { return noted(a.value / b.value, Kind::divide, 0, a, b); }
/// a b + c in one operation
inline real fused(real a, real b, real c) {
  if (is_zero(a) || is_zero(b)) return c;
  return is_zero(c) ? a * b : real(std::fma(a.value, b.value, c.value), Kind::fused, {a.node, b.node, c.node});
}
inline real operator-(real a) { return noted(-a.value, Kind::free, 0, a); }  // a sign goes into the next operation
inline mask operator<(real a, real b) { return noted(int(a.value < b.value), Kind::compare, 0, a, b); }
inline mask operator>(real a, real b) { return noted(int(a.value > b.value), Kind::compare, 1, a, b); }
inline mask operator<=(real a, real b) { return noted(int(a.value <= b.value), Kind::compare, 2, a, b); }
inline mask operator>=(real a, real b) { return noted(int(a.value >= b.value), Kind::compare, 3, a, b); }
inline mask operator==(real a, real b) { return noted(int(a.value == b.value), Kind::compare, 4, a, b); }
inline mask operator!=(real a, real b) { return noted(int(a.value != b.value), Kind::compare, 5, a, b); }

inline integer operator+(integer a, integer b) { return noted(a.value + b.value, Kind::whole, 0, a, b); }
inline integer operator-(integer a, integer b) { return noted(a.value - b.value, Kind::whole, 1, a, b); }
inline integer operator*(integer a, integer b) { return noted(a.value * b.value, Kind::whole, 2, a, b); }
inline integer operator&(integer a, integer b) { return noted(a.value & b.value, Kind::whole, 3, a, b); }
inline integer operator|(integer a, integer b) { return noted(a.value | b.value, Kind::whole, 4, a, b); }
inline integer operator<<(integer a, integer b) { return noted(a.value << b.value, Kind::whole, 9, a, b); }
inline mask operator!(mask a) { return noted(int(!a.value), Kind::whole, 5, a); }

RELUME_FN real choose(mask m, real a, real b) {
  return a.node == b.node ? a : real(m.value ? a.value : b.value, Kind::select, {m.node, a.node, b.node});
}
RELUME_FN integer choose_integer(mask m, integer a, integer b) {
  return integer(m.value ? a.value : b.value, Kind::select, {m.node, a.node, b.node});
}
RELUME_FN real square_root(real x) { return noted(std::sqrt(x.value), Kind::root, 0, x); }
RELUME_FN real whole_below(real x) { return noted(std::floor(x.value), Kind::whole, 6, x); }
RELUME_FN real absolute(real x) { return noted(std::fabs(x.value), Kind::free, 1, x); }
RELUME_FN real as_real(integer x) { return noted(std::bit_cast<float>(x.value), Kind::free, 2, x); }
RELUME_FN integer as_integer(real x) { return noted(std::bit_cast<int>(x.value), Kind::free, 3, x); }
RELUME_FN real to_real(integer x) { return noted(float(x.value), Kind::whole, 7, x); }
RELUME_FN integer to_integer(real x) { return noted(int(x.value), Kind::whole, 8, x); }
RELUME_FN real all_lanes(float x) { return x; }
RELUME_FN int any_of(mask m) {
  tape.decided.push_back(m.node);
  return m.value;
}
RELUME_FN real load(const float* p) { return real(*p, Kind::load, {std::int64_t(reinterpret_cast<std::intptr_t>(p)), 0, 0}); }
RELUME_FN void store(real x, float*) { tape.stored.push_back(x.node); }
RELUME_FN void store_past_cache(real x, float* p) { store(x, p); }
RELUME_FN float least_of(real x) { return x.value; }
RELUME_FN real gather(const float* table, integer index) {
  return real(table[index.value], Kind::load, {std::int64_t(reinterpret_cast<std::intptr_t>(table)), index.node, 1});
}
