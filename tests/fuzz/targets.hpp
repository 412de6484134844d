// What libFuzzer calls, and replay.cpp in its place.
#pragma once

#include <cstddef>
#include <cstdint>

/// Chooses the target by the first argument, --NAME: libFuzzer passes over what begins with two
/// dashes, and gives it to processes that it starts. Ends the process, status 2, if there is none.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
