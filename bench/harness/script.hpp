// Peers in Python: scripts in bench/peers that read what they are asked as JSON.
#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace vcrit::bench {

/// Runs peers/NAME with the file of `input`, then `words`, in `folder`; returns what it said.
/// Throws std::runtime_error where it fails or is not back in time.
std::string run_script(const std::string& name, const nlohmann::ordered_json& input,
                       const std::vector<std::string>& words, const std::filesystem::path& folder,
                       std::chrono::seconds longest);

}  // namespace vcrit::bench
