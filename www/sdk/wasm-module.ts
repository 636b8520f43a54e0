/** Types of compiled and raw wasm that programs without TypeScript's DOM library can read too. */

/** A compiled wasm file: `WebAssembly.Module`. Without the DOM library that type has no name, and any object is accepted. */
export type WasmModule = typeof globalThis extends { WebAssembly: { Module: { prototype: infer Module } } } ? Module : object;

/** The bytes of a wasm file: `BufferSource` of the DOM library. */
export type WasmBytes = ArrayBuffer | ArrayBufferView<ArrayBuffer>;
