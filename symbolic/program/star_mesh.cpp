#include "program/star_mesh.hpp"

#include <algorithm>

#include "network/reduction.hpp"

namespace vcrit::symbolic {

namespace {

class Mesh {
 public:
  /// Edges may leave the first quadrant: each carries its error in roundings, to first order in
  /// what came before (the factor 1.01 covers the rest), and its absolute value.
  struct Value {
    ComplexNode k;
    NodeId roundings, size;
  };

  Mesh(Program& program, const std::function<MeshElement(const Element&)>& element)
      : program_(program), element_(element) {}

  Value element(const Element& e) {
    const auto [t, q, before] = element_(e);
    if (is_one(program_, q)) return edge(t, program_.constant(std::max(before, 1)));
    // i y/(1 + i x) = y (x + i)/(1 + x^2): x 1, y 2, 1 + x^2 4, quotient 7, times x 9; each that x
    // and y have before that once in y, twice in x^2 and once in x.
    const NodeId x = q.im;
    const NodeId g = program_.divide(t.im, program_.multiply_add(x, x, program_.constant(1)));
    const int earlier = 4 * std::max(before - 3, 0);
    return edge({program_.multiply(g, x), g}, program_.constant(9 + earlier));
  }

  Value parallel(const Value& a, const Value& b) {
    const NodeId size_a = program_.multiply(a.roundings, a.size);
    const NodeId size_b = program_.multiply(b.roundings, b.size);
    const ComplexNode k{program_.add(a.k.re, b.k.re), program_.add(a.k.im, b.k.im)};
    const NodeId sizes = program_.add(size_a, size_b);
    // Without error where both edges are 0.
    const NodeId before = program_.divide(sizes, program_.nonzero(length(k), sizes));
    return edge(k, program_.multiply(factor(), program_.add(before, program_.constant(1))));
  }

  Value series(const Value& a, const Value& b) { return mesh(a, b, parallel(a, b)); }

  // a b/total: product 3, quotient of complex numbers 7.
  Value mesh(const Value& a, const Value& b, const Value& total) {
    const ComplexNode product = sum_of_products(program_, {{a.k, b.k}}).value;
    const ComplexNode conjugate{total.k.re, program_.negate(total.k.im)};
    const ComplexNode top = sum_of_products(program_, {{product, conjugate}}).value;
    const NodeId norm = program_.nonzero(square(program_, total.k), program_.constant(0));
    const NodeId before = program_.add(program_.add(a.roundings, b.roundings), total.roundings);
    return edge({program_.divide(top.re, norm), program_.divide(top.im, norm)},
                program_.multiply(factor(), program_.add(before, program_.constant(10))));
  }

 private:
  NodeId factor() { return program_.constant(GiNaC::numeric(1034, 1024)); }

  NodeId length(const ComplexNode& k) {
    if (program_.is_constant(k.im, 0)) return program_.size(k.re);
    if (program_.is_constant(k.re, 0)) return program_.size(k.im);
    const NodeId re = program_.size(k.re), im = program_.size(k.im);
    return program_.root(program_.add(program_.multiply(re, re), program_.multiply(im, im)));
  }

  Value edge(const ComplexNode& k, NodeId roundings) {
    const NodeId size = length(k);
    return {k, program_.add(roundings, program_.unless_moderate(size)), size};
  }

  Program& program_;
  const std::function<MeshElement(const Element&)>& element_;
};

}  // namespace

MeshedStiffness by_star_mesh(Program& program, const Network& network,
                             const std::function<MeshElement(const Element&)>& element) {
  Mesh mesh(program, element);
  const Mesh::Value whole = evaluate(reduce(network), mesh);
  return {whole.k, whole.roundings};
}

}  // namespace vcrit::symbolic
