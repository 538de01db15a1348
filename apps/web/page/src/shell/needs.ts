// What a browser has to have.

/** What this browser lacks, in words; empty where it lacks nothing. */
export function lacking(): string {
  const missing = [
    typeof WebAssembly === 'object' ? '' : 'WebAssembly',
    typeof DecompressionStream === 'function' ? '' : 'DecompressionStream',
    typeof Worker === 'function' ? '' : 'web workers',
  ].filter(Boolean);
  if (missing.length === 0) return '';
  return `This browser lacks ${missing.join(' and ')}, so the page cannot work. Any browser from 2023 or later has what it needs.`;
}
