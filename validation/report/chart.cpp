#include "report/chart.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "figures/figure_json.hpp"
#include "report/html.hpp"

namespace vcrit::validation::report {

namespace {

std::string drawn(const figures::Figure& figure, const std::string& heading) {
  return fmt::format(
      "<figure id=\"{}\">{}<div class=\"chart\" role=\"group\" aria-label=\"{}\"></div>"
      "<script type=\"application/json\">{}</script><figcaption>{}</figcaption></figure>\n",
      escape(figure.name), heading, escape(figure.title), json_for_page(figure_json(figure)),
      escape(figure.caption));
}

}  // namespace

std::string chart(const figures::Figure& figure) { return drawn(figure, ""); }

std::string panels(const std::vector<figures::Figure>& figures) {
  std::string html;
  for (const figures::Figure& figure : figures)
    html += drawn(figure, "<p class=\"panel-title\">" + escape(figure.title) + "</p>");
  return "<div class=\"panels\">\n" + html + "</div>\n";
}

}  // namespace vcrit::validation::report
