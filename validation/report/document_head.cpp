#include "report/document_head.hpp"

#include <fmt/format.h>

#include "report/assets.hpp"
#include "report/html.hpp"

namespace vcrit::validation::report {

std::string document_head(const std::string& title, const std::string& policy) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>{} · vcrit</title>\n<style>\n{}</style>\n</head>\n",
      policy, escape(title), style());
}

}  // namespace vcrit::validation::report
