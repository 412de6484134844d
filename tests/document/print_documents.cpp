// Documents for tests: print_documents all|asked|exported.
#include <map>
#include <string>

#include "document/printed.hpp"

int main(int, char** words) {
  using namespace vcrit::test;
  const std::map<std::string, void (*)()> commands{
      {"all", print_all}, {"asked", print_asked}, {"exported", export_all}};
  commands.at(words[1])();
}
