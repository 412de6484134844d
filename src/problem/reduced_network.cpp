#include "problem/reduced_network.hpp"

#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

#include "network/masses.hpp"

namespace vcrit {

namespace {

std::atomic<std::size_t> reductions = 0;

}  // namespace

struct ReducedNetwork::Shared {
  Network network;
  bool has_masses = false;
  std::mutex making;
  std::atomic<bool> is_made = false;
  std::optional<Reduction> reduction;  // never changed once is_made
};

ReducedNetwork::ReducedNetwork(Network network) : shared_(std::make_shared<Shared>()) {
  shared_->has_masses = vcrit::has_masses(network);
  shared_->network = std::move(network);
}

const Network& ReducedNetwork::network() const { return shared_->network; }

bool ReducedNetwork::has_masses() const { return shared_->has_masses; }

const Reduction& ReducedNetwork::reduction() const {
  if (!shared_->is_made.load(std::memory_order_acquire)) {
    const std::lock_guard lock(shared_->making);
    if (!shared_->reduction) {
      shared_->reduction = reduce(shared_->network);
      ++reductions;
    }
    shared_->is_made.store(true, std::memory_order_release);
  }
  return *shared_->reduction;
}

std::size_t reductions_made() { return reductions; }

}  // namespace vcrit
