/** Written by the build: the wasm file of the writers in base64. */
declare const base64: string;
export default base64;
