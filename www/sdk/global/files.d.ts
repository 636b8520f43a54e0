/** Files that the bundler includes in the script. */

declare module '*.wasm' {
  const bytes: Uint8Array<ArrayBuffer>;
  export default bytes;
}

declare module '*.worker' {
  const text: string;
  export default text;
}
