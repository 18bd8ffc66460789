// Numbers for people.

export function text(value, digits = 5) {
  if (!Number.isFinite(value)) return "no value";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) return String(Number(value.toPrecision(digits)));
  return Number(value.toPrecision(digits)).toExponential().replace("e+", "e");
}

export function withUnit(value, unit, digits = 5) {
  return text(value, digits) + (unit ? " " + unit : "");
}

// Ticks at steps of 1, 2 or 5 times a power of ten that cover a range: rounded_ticks of the program, in its src/plot.
export function roundedTicks(low, high, about = 6) {
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (!(high - low > 1e-9 * size)) {
    const pad = size > 0 ? 0.01 * size : 1;
    low -= pad;
    high += pad;
  }
  const raw = (high - low) / about;
  const decade = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * decade).find((size) => size >= raw * 0.999);
  const first = Math.floor(low / step + 1e-6), last = Math.ceil(high / step - 1e-6);
  const ticks = [];
  for (let i = first; i <= last; i++) ticks.push(i * step);
  return ticks;
}
