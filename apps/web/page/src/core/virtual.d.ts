declare module 'virtual:core' {
  /** The core's WebAssembly: gzip, then base64. */
  const packed: string;
  export default packed;
}
