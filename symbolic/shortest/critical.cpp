#include "shortest/critical.hpp"

#include <algorithm>

namespace vcrit::symbolic::shortest {

namespace {

/// Whether it has one presentation: springs and dampers side by side.
bool is_simple(const Network& network) {
  const auto is_element = [](const Network& part) {
    const auto* e = std::get_if<Element>(&part.form);
    return e != nullptr && (e->kind == ElementKind::spring || e->kind == ElementKind::damper);
  };
  const auto* parallel = std::get_if<Parallel>(&network.form);
  if (parallel == nullptr) return is_element(network);
  return std::all_of(parallel->parts.begin(), parallel->parts.end(), is_element);
}

class CriticalVelocity {
 public:
  CriticalVelocity(Expressions& all, Presentations& presentations, const Parts& parts)
      : all_(all), complex_(all), presentations_(presentations), parts_(parts) {}

  std::vector<Ex> all() {
    if (parts_.mount != nullptr) write_mounts();
    if (parts_.tangential == nullptr)
      isotropic();
    else
      own_tangential();
    return std::move(found_);
  }

 private:
  using Quotients = std::vector<ComplexQuotient>;

  void offer(const Ex& factor) {
    const Ex whole = all_.multiply(parts_.prefactor, factor);
    if (parts_.mount == nullptr) return offer_whole(whole);
    for (const Ex& mount : mounts_) offer_whole(all_.multiply(whole, mount));
  }

  void offer_whole(const Ex& whole) {
    if (std::find(found_.begin(), found_.end(), whole) == found_.end()) found_.push_back(whole);
  }

  /// |M|/|M' + K_n|, M' = K_m - m_n omega^2: each network in its first way, and with the whole
  /// below one bar or two.
  void write_mounts() {
    const ComplexQuotient m = presentations_.of(*parts_.mount)[0];
    const ComplexQuotient n = presentations_.of(*parts_.normal)[0];
    std::vector<ComplexQuotient> sum{m, n};
    if (parts_.mount_mass)
      sum.push_back({from_real(Expressions::negative(presentations_.inertia(*parts_.mount_mass)))});
    for (const bool one_denominator : {false, true})
      mounts_.push_back(all_.divide(complex_.modulus(m),
                                    complex_.modulus(presentations_.sum(sum, one_denominator))));
  }

  /// D = K_d - m omega^2. Where the drive is a network of the contact, written as that is here.
  Quotients drive(const Network* same, const ComplexQuotient& written) {
    const bool own = same == nullptr || !(*parts_.drive == *same) || is_simple(*parts_.drive);
    if (own) return presentations_.swinging(*parts_.drive, parts_.mass);
    if (!parts_.mass) return {written};
    const ComplexQuotient mass{
        from_real(Expressions::negative(presentations_.inertia(*parts_.mass)))};
    return {presentations_.sum({written, mass}, false)};
  }

  /// |K + D|/|D| from two presentations.
  Ex joined(const ComplexQuotient& k, const ComplexQuotient& d) {
    if (k.under == d.under)
      return all_.divide(complex_.modulus(complex_.add(k.over, d.over)), complex_.modulus(d.over));
    const ComplexEx both =
        complex_.add(complex_.multiply(k.over, d.under), complex_.multiply(d.over, k.under));
    return all_.product({{complex_.modulus(both), 1},
                         {complex_.modulus(k.under), -1},
                         {complex_.modulus(d.over), -1}});
  }

  /// |1/K + 1/D| in two ways.
  std::vector<Ex> compliances(const ComplexQuotient& k, const ComplexQuotient& d) {
    std::vector<Ex> result;
    for (const ComplexQuotient& j : {reciprocal(d), complex_.cartesian(reciprocal(d))})
      for (const bool one_denominator : {false, true})
        result.push_back(complex_.modulus(presentations_.sum({reciprocal(k), j}, one_denominator)));
    return result;
  }

  void isotropic() {
    if (parts_.drive == nullptr) return offer(parts_.ratio);
    for (const ComplexQuotient& k : presentations_.of(*parts_.normal))
      for (const ComplexQuotient& d : drive(parts_.normal, k)) isotropic(k, d);
    for (const ComplexQuotient& d : drive(nullptr, {}))
      for (const ComplexQuotient& whole : presentations_.beside(*parts_.normal, scaled(d)))
        offer(all_.divide(complex_.modulus(whole), complex_.modulus(d)));
  }

  ComplexQuotient scaled(const ComplexQuotient& d) { return complex_.multiply(d, parts_.ratio); }

  void isotropic(const ComplexQuotient& k, const ComplexQuotient& d) {
    offer(all_.multiply(joined(k, scaled(d)), parts_.ratio));
    for (const Ex& compliance : compliances(k, scaled(d)))
      offer(all_.product({{parts_.ratio, 1}, {compliance, 1}, {complex_.modulus(k), 1}}));
    // |1 + K/(g D)|
    const ComplexQuotient over{k.over, complex_.multiply(k.under, scaled(d).over)};
    if (d.under.is_one())
      offer(all_.multiply(parts_.ratio, complex_.modulus(presentations_.sum(
                                            {over, {from_real(Expressions::number(1))}}, false))));
  }

  void own_tangential() {
    const Quotients contact = presentations_.of(*parts_.normal);
    const std::vector<Ex> rest = tangential_factors();
    for (const ComplexQuotient& k : contact)
      for (const Ex& each : rest) offer(all_.multiply(complex_.modulus(k), each));
  }

  /// |K_t + D|/(|K_t| |D|)
  std::vector<Ex> tangential_factors() {
    std::vector<Ex> all;
    for (const ComplexQuotient& t : presentations_.of(*parts_.tangential)) {
      const Ex quotient = all_.power(complex_.modulus(t), -1);
      if (parts_.drive == nullptr) {
        all.push_back(quotient);
        continue;
      }
      for (const ComplexQuotient& d : drive(parts_.tangential, t)) {
        all.push_back(all_.multiply(quotient, joined(t, d)));
        for (const Ex& compliance : compliances(t, d)) all.push_back(compliance);
      }
    }
    if (parts_.drive == nullptr) return all;
    for (const ComplexQuotient& d : drive(nullptr, {})) beside_and_behind(all, d);
    return all;
  }

  void beside_and_behind(std::vector<Ex>& all, const ComplexQuotient& d) {
    for (const ComplexQuotient& t : presentations_.of(*parts_.tangential))
      for (const ComplexQuotient& whole : presentations_.beside(*parts_.tangential, d))
        all.push_back(all_.product(
            {{complex_.modulus(t), -1}, {complex_.modulus(whole), 1}, {complex_.modulus(d), -1}}));
    for (const ComplexQuotient& j : {reciprocal(d), complex_.cartesian(reciprocal(d))})
      for (const ComplexQuotient& whole : presentations_.behind(*parts_.tangential, j))
        all.push_back(complex_.modulus(whole));
  }

  Expressions& all_;
  ComplexAlgebra complex_;
  Presentations& presentations_;
  const Parts& parts_;
  std::vector<Ex> found_, mounts_;
};

}  // namespace

std::vector<Ex> critical_velocities(Expressions& all, Presentations& presentations,
                                    const Parts& parts) {
  return CriticalVelocity(all, presentations, parts).all();
}

}  // namespace vcrit::symbolic::shortest
