// v* in storage and loss of each network, K(i omega) = K' + i K'': with these and D = K_d' - m
// omega^2 + i K_d'' it is mu0 omega du_z |K_n|/|K_t| |K_t + D|/|D|, and of an isotropic contact mu0
// omega du_z |K_n + g D|/|D|. Storage and loss have a line each, written out, and the steps that
// they share have names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "shortest/shortest.hpp"

namespace vcrit::symbolic {

/// None of a measured drive, nor where writing it takes too much work.
FoundForm find_storage_loss_form(const Problem& problem);

/// K' and K'' of one of the networks of a problem, written out in named steps.
struct StorageAndLoss {
  std::vector<ShortestForm::Definition>
      steps;                        ///< with lines for K' and K'', unless they are short
  Form storage, loss;               ///< in the names of the steps
  std::optional<Form> loss_factor;  ///< K''/K'; none where K' = 0
};

/// Proved to be the network's; none where writing it takes too much work. `name`: "K_n".
std::optional<StorageAndLoss> storage_and_loss_of(const Problem& problem,
                                                  const ReducedNetwork& network,
                                                  const std::string& name);

}  // namespace vcrit::symbolic
