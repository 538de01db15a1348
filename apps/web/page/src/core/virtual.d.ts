declare module 'virtual:core' {
  /** The core's WebAssembly: gzip, then base64. */
  const packed: string;
  export default packed;
}

declare module 'virtual:frame' {
  /** The script of the sandboxed frame, and how a policy names it. */
  export const script: string;
  export const hash: string;
}

declare module 'virtual:editor' {
  /** The script of the editor, which leaves `labmouseEditor` behind: gzip, then base64. */
  const packed: string;
  export default packed;
}
