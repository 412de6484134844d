// A moment of one period: a slider chooses it, a button lets the time run.
"use strict";

const vcrit_scrubber = (() => {
  const slow_motion = 6000;  // ms a period
  const still = matchMedia("(prefers-reduced-motion: reduce)");

  /// The slider goes from 0 to 1000; `show` is given the part of the period, 0 to 1, whenever it changes.
  return ({ button, slider, show }) => {
    const part = () => Number(slider.value) / 1000;
    let playing = false, last = 0;

    function frame(now) {
      if (!playing) return;
      slider.value = String((Number(slider.value) + 1000 * (now - last) / slow_motion) % 1000);
      last = now;
      show(part());
      requestAnimationFrame(frame);
    }

    function play(on) {
      playing = on;
      button.textContent = on ? "Pause" : "Play";
      button.setAttribute("aria-pressed", String(on));
      if (!on) return;
      last = performance.now();
      requestAnimationFrame(frame);
    }

    // Who wants no motion has the slider.
    const calm = () => { if (still.matches) play(false); button.hidden = still.matches; };
    slider.addEventListener("input", () => { play(false); show(part()); });
    button.addEventListener("click", () => play(!playing));
    still.addEventListener("change", calm);
    calm();
    return { part };
  };
})();
