// C++ exceptions in WebAssembly. The simulator's searches throw and catch; Debian's libc++abi for
// wasm32 is built without them, so that its part is here: the ABI's functions that the compiler
// calls with -fwasm-exceptions, for one thread. Tables: LLVM's ExceptionHandling,
// lib/CodeGen/AsmPrinter/EHStreamer.cpp.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <typeinfo>

namespace {

// What stands before each thrown object.
struct Header {
  const std::type_info* type;
  void* (*destroy)(void*);  // destructors give back what they destroyed, in WebAssembly
  void* caught;             // the object as the catch clause sees it
  int handlers;
  Header* below;  // of those being handled, the one before
};

constexpr std::size_t header_size = (sizeof(Header) + 15) / 16 * 16;
Header* handled = nullptr;

void* object_of(Header* header) { return reinterpret_cast<char*>(header) + header_size; }
Header* header_of(void* object) {
  return reinterpret_cast<Header*>(static_cast<char*>(object) - header_size);
}

// libc++abi's type_info, whose last virtual function says what a catch clause catches.
struct CatchType : std::type_info {
  virtual void first() const;
  virtual void second() const;
  virtual bool can_catch(const CatchType* thrown, void*& object) const = 0;
};

struct Bytes {
  const std::uint8_t* at;

  std::uintptr_t number() {
    std::uintptr_t result = 0;
    for (unsigned shift = 0;; shift += 7) {
      const std::uint8_t byte = *at++;
      result |= static_cast<std::uintptr_t>(byte & 0x7F) << shift;
      if (byte < 0x80) return result;
    }
  }
  std::intptr_t signed_number() {
    std::intptr_t result = 0;
    for (unsigned shift = 0;;) {
      const std::uint8_t byte = *at++;
      result |= static_cast<std::intptr_t>(byte & 0x7F) << shift;
      shift += 7;
      if (byte >= 0x80) continue;
      if ((byte & 0x40) != 0 && shift < 32) result |= -(std::intptr_t{1} << shift);
      return result;
    }
  }
};

}  // namespace

// Names and layout are the compiler's.
extern "C" {

struct Context {
  std::uintptr_t place;
  const std::uint8_t* table;
  std::uintptr_t selector;
} __wasm_lpad_context;

int __gxx_wasm_personality_v0(...) { return 0; }

int _Unwind_CallPersonality(void* exception) {
  auto* header = static_cast<Header*>(exception);
  __wasm_lpad_context.selector = 0;
  Bytes bytes{__wasm_lpad_context.table};
  ++bytes.at;  // no start of landing pads
  const bool has_types = *bytes.at++ != 0xFF;
  const std::uintptr_t types_after = has_types ? bytes.number() : 0;
  const auto* const types = reinterpret_cast<const std::type_info* const*>(bytes.at + types_after);
  ++bytes.at;  // encoding of places
  const std::uintptr_t length = bytes.number();
  const std::uint8_t* const actions = bytes.at + length;
  std::uintptr_t action = 0;
  for (std::uintptr_t i = 0; i <= __wasm_lpad_context.place; ++i) {
    bytes.number();
    action = bytes.number();
  }
  if (action == 0) return 0;
  for (Bytes next{actions + action - 1};;) {
    const std::intptr_t type = next.signed_number();
    const std::uint8_t* const here = next.at;
    if (type > 0) {
      const auto* catches = static_cast<const CatchType*>(types[-type]);
      void* object = object_of(header);
      if (catches == nullptr ||
          catches->can_catch(static_cast<const CatchType*>(header->type), object)) {
        header->caught = object;
        __wasm_lpad_context.selector = static_cast<std::uintptr_t>(type);
        return 0;
      }
    }
    const std::intptr_t offset = next.signed_number();
    if (offset == 0) return 0;
    next.at = here + offset;
  }
}

void* __cxa_allocate_exception(std::size_t size) {
  void* memory = std::malloc(header_size + size);
  if (memory == nullptr) std::abort();
  return object_of(new (memory) Header{});
}
void __cxa_free_exception(void* object) { std::free(header_of(object)); }

void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Header* header = header_of(object);
  *header = {type, destroy, object, 0, nullptr};
  __builtin_wasm_throw(0, header);
}

void* __cxa_get_exception_ptr(void* exception) { return static_cast<Header*>(exception)->caught; }

void* __cxa_begin_catch(void* exception) {
  auto* header = static_cast<Header*>(exception);
  header->handlers = (header->handlers < 0 ? -header->handlers : header->handlers) + 1;
  if (header != handled) {
    header->below = handled;
    handled = header;
  }
  return header->caught;
}

// Below 0: thrown again, so that the end of its handler leaves it alive.
void __cxa_end_catch() {
  Header* header = handled;
  const bool again = header->handlers < 0;
  header->handlers += again ? 1 : -1;
  if (header->handlers != 0) return;
  handled = header->below;
  if (again) return;
  if (header->destroy != nullptr) header->destroy(object_of(header));
  std::free(header);
}

void __cxa_rethrow() {
  handled->handlers = -handled->handlers;
  __builtin_wasm_throw(0, handled);
}

}  // extern "C"
