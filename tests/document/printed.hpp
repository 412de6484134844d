// The commands of print_documents, compiled together.
#pragma once

namespace vcrit::test {

void print_all();
/// Reads what is asked for, a line each.
void print_asked();
/// Reads scenes, each ended by a zero.
void export_all();

}  // namespace vcrit::test
