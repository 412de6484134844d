// Nothing but the framework's header, which is compiled with this file once for all tests (tests/CMakeLists.txt).
