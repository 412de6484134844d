// The kernels for one level of the processor, VCRIT_LEVEL. Nothing that another file might share is
// included here: code of a higher level must not get into the rest of the program.
#include <cmath>

#include "critical/kernels.hpp"

namespace vcrit::kernels::VCRIT_LEVEL {

extern const Kernels table;

namespace {

void multiply_lanes(double* __restrict out, const double* a, const double* b) {
  for (std::size_t i = 0; i < lanes; ++i) out[i] = a[i] * b[i];
}

void divide_lanes(double* __restrict out, const double* a, const double* b) {
  for (std::size_t i = 0; i < lanes; ++i) out[i] = a[i] / b[i];
}

void add_lanes(double* __restrict out, const double* a, const double* b) {
  for (std::size_t i = 0; i < lanes; ++i) out[i] = a[i] + b[i];
}

void maxwell_lanes(LanesResult out, const double* k, const double* tau, const double* omega) {
  double* __restrict storage = out.storage;
  double* __restrict loss = out.loss;
  for (std::size_t i = 0; i < lanes; ++i) {
    const double x = omega[i] * tau[i];
    const double l = k[i] * x / (1 + x * x);
    storage[i] = l * x;
    loss[i] = l;
  }
}

// 1/(1/a + 1/b) = (a |b|^2 + b |a|^2)/|a + b|^2 in both components.
void series_lanes(LanesResult out, StiffnessLanes a, StiffnessLanes b) {
  double* __restrict storage = out.storage;
  double* __restrict loss = out.loss;
  for (std::size_t i = 0; i < lanes; ++i) {
    const double re = a.storage[i] + b.storage[i], im = a.loss[i] + b.loss[i];
    const double inverse = 1 / (re * re + im * im);
    const double share_a = (a.storage[i] * a.storage[i] + a.loss[i] * a.loss[i]) * inverse;
    const double share_b = (b.storage[i] * b.storage[i] + b.loss[i] * b.loss[i]) * inverse;
    storage[i] = a.storage[i] * share_b + b.storage[i] * share_a;
    loss[i] = a.loss[i] * share_b + b.loss[i] * share_a;
  }
}

void mesh_lanes(LanesResult out, StiffnessLanes a, StiffnessLanes b, StiffnessLanes total) {
  double* __restrict storage = out.storage;
  double* __restrict loss = out.loss;
  for (std::size_t i = 0; i < lanes; ++i) {
    const double re = total.storage[i], im = total.loss[i];
    const double inverse = 1 / (re * re + im * im);
    const double share_re = (a.storage[i] * re + a.loss[i] * im) * inverse;
    const double share_im = (a.loss[i] * re - a.storage[i] * im) * inverse;
    storage[i] = share_re * b.storage[i] - share_im * b.loss[i];
    loss[i] = share_re * b.loss[i] + share_im * b.storage[i];
  }
}

void isotropic_lanes(double* __restrict out, double* __restrict lost, const double* poisson) {
  for (std::size_t i = 0; i < lanes; ++i) {
    out[i] = 2 * (1 - poisson[i]) / (2 - poisson[i]);
    lost[i] = ((poisson[i] > -1) & (poisson[i] <= 0.5)) ? lost[i] : 1;
  }
}

void modulus_ratio_lanes(double* __restrict out, StiffnessLanes a, StiffnessLanes b) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const double above = a.storage[i] * a.storage[i] + a.loss[i] * a.loss[i];
    const double below = b.storage[i] * b.storage[i] + b.loss[i] * b.loss[i];
    out[i] = std::sqrt(above / below);
  }
}

// The last bits that stiffness - m omega^2 would lose to the rounding of the product.
inline double minus_inertia_of_lane(double stiffness, double mass, double omega) {
  const double square = omega * omega, square_error = std::fma(omega, omega, -square);
  const double inertia = mass * square, inertia_error = std::fma(mass, square, -inertia);
  return (stiffness - inertia) - (inertia_error + mass * square_error);
}

void massless_factor_lanes(double* __restrict out, StiffnessLanes t, StiffnessLanes d) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const double re = t.storage[i] + d.storage[i], im = t.loss[i] + d.loss[i];
    out[i] = std::sqrt((re * re + im * im) / (d.storage[i] * d.storage[i] + d.loss[i] * d.loss[i]));
  }
}

void drive_factor_lanes(double* __restrict out, double* __restrict lost, StiffnessLanes t,
                        const Drive& drive) {
  const StiffnessLanes d = drive.network;
  if (drive.mass == nullptr) return massless_factor_lanes(out, t, d);
  const double of_contact = drive.exact_contact ? 0 : 1, of_drive = drive.exact_drive ? 0 : 1;
  constexpr double worst = worst_cancellation * worst_cancellation;
  const double* mass = drive.mass;
  const double* omega = drive.omega;
  for (std::size_t i = 0; i < lanes; ++i) {
    // The exact sum of both storage stiffnesses is sum + rest.
    const double sum = t.storage[i] + d.storage[i], shadow = sum - t.storage[i];
    const double rest = (t.storage[i] - (sum - shadow)) + (d.storage[i] - shadow);
    const double above = minus_inertia_of_lane(sum, mass[i], omega[i]) + rest;
    const double below = minus_inertia_of_lane(d.storage[i], mass[i], omega[i]);
    const double above_loss = t.loss[i] + d.loss[i];
    const double above_norm = above * above + above_loss * above_loss;
    const double below_norm = below * below + d.loss[i] * d.loss[i];
    out[i] = std::sqrt(above_norm / below_norm);
    const double uncertain = of_drive * (d.storage[i] + d.loss[i]);
    const double uncertain_above = of_contact * (t.storage[i] + t.loss[i]) + uncertain;
    const bool holds = below_norm > 0 && above_norm > 0 &&
                       worst * below_norm >= uncertain * uncertain &&
                       worst * above_norm >= uncertain_above * uncertain_above;
    lost[i] = holds ? lost[i] : 1;
  }
}

void lanes_outside_range(double* __restrict lost, const double* x) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const bool usual = (x[i] >= least_usual) & (x[i] <= most_usual);
    lost[i] = usual ? lost[i] : 1;
  }
}

}  // namespace

const Kernels table{multiply_lanes,     divide_lanes,       add_lanes,       maxwell_lanes,
                    series_lanes,       mesh_lanes,         isotropic_lanes, modulus_ratio_lanes,
                    drive_factor_lanes, lanes_outside_range};

}  // namespace vcrit::kernels::VCRIT_LEVEL
