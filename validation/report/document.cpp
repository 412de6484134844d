#include "report/document.hpp"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <array>
#include <cctype>

#include "base/errors.hpp"
#include "report/assets.hpp"
#include "report/html.hpp"

namespace vcrit::validation::report {

namespace {

std::vector<std::string_view> scripts_of(const Document& content) {
  std::vector<std::string_view> result;
  if (content.charts)
    for (const std::string_view script : scripts()) result.push_back(script);
  result.insert(result.end(), content.scripts.begin(), content.scripts.end());
  return result;
}

/// HTML reads a script's text for these alone, in whatever case.
bool ends_early(std::string_view script) {
  for (std::size_t at = script.find('<'); at != script.npos; at = script.find('<', at + 1)) {
    std::string next(script.substr(at, 8));
    for (char& c : next) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (next == "</script" || next.starts_with("<!--")) return true;
  }
  return false;
}

std::string policy(const std::vector<std::string_view>& scripts) {
  std::string allowed = "default-src 'none'; ";
  if (!scripts.empty()) {
    allowed += "script-src";
    for (const std::string_view script : scripts) allowed += " '" + script_hash(script) + "'";
    allowed += "; img-src data: blob:; ";
  }
  return allowed + "style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";
}

}  // namespace

std::string script_hash(std::string_view text) {
  std::array<unsigned char, 32> hash{};
  unsigned size = 0;
  ensure(EVP_Digest(text.data(), text.size(), hash.data(), &size, EVP_sha256(), nullptr) == 1 &&
             size == hash.size(),
         "a SHA-256");
  std::array<unsigned char, 45> base64{};  // four letters for three bytes, and a zero
  EVP_EncodeBlock(base64.data(), hash.data(), static_cast<int>(hash.size()));
  return "sha256-" + std::string(base64.begin(), base64.end() - 1);
}

std::string document(const Document& content) {
  const auto scripts = scripts_of(content);
  for (const std::string_view script : scripts) ensure(!ends_early(script), "a script is whole");
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>{} · vcrit</title>\n<style>\n{}</style>\n</head>\n<body>\n{}",
      policy(scripts), escape(content.title), style(), content.body);
  for (const std::string_view script : scripts)
    html += fmt::format("<script>{}</script>\n", script);
  return html + "</body>\n</html>\n";
}

}  // namespace vcrit::validation::report
