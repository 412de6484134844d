// The simulator in the page: inflates the module, loads a scene into it and asks. Each question gives
// { status, message, numbers }: status 0, or as the program's exit status 2 (input), 3 (outside the model) or 1 (a bug).
"use strict";

const vcrit_simulator = (() => {
  // libc asks for these; there is no file and no environment.
  const nothing = {
    environ_get: () => 0,
    environ_sizes_get: (count, size) => { memory().setUint32(count, 0, true); memory().setUint32(size, 0, true); return 0; },
    fd_close: () => 8,
    fd_seek: () => 8,
    fd_write: () => 8,
    proc_exit: (status) => { throw new Error(`the simulator stopped (${status})`); },
  };
  let exports;
  const memory = () => new DataView(exports.memory.buffer);

  async function inflated(base64) {
    const letters = atob(base64), packed = new Uint8Array(letters.length);
    for (let at = 0; at < packed.length; at++) packed[at] = letters.charCodeAt(at);
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
  }

  function answered(status) {
    const at = exports.results();
    const numbers = [...new Float64Array(exports.memory.buffer, at, exports.results_size())];
    const words = new Uint8Array(exports.memory.buffer, exports.message(), exports.message_size());
    return { status, message: new TextDecoder().decode(words), numbers };
  }

  /// The scene's text as scene_text writes it; answers with its numbers.
  function load(text) {
    const bytes = new TextEncoder().encode(text);
    const at = exports.room(bytes.length);
    new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
    return answered(exports.load());
  }

  /// From the bytes of the module.
  async function start(bytes) {
    const { instance } = await WebAssembly.instantiate(bytes, { wasi_snapshot_preview1: nothing });
    exports = instance.exports;
    exports._initialize();
    const asking = (name) => (...words) => answered(exports[name](...words));
    return {
      load,
      set: (place, value) => exports.set(place, value),
      ...Object.fromEntries(["move", "reasons", "critical", "closed", "load_on_average", "friction_next", "friction"]
        .map((name) => [name, asking(name)])),
    };
  }

  return { inflated, start };
})();
