import { expect, it } from "vitest";

import { abortText, kAbortTexts } from "../../../src/canopen/sdo/abort_codes";
import { projectText } from "../data/files";

it("has the abort codes of libcanopen with their texts", () => {
  const codes = new Map(
    [...projectText("libcanopen/od/abort_code.hpp").matchAll(/(\w+) = (0x[0-9A-F]{8}),/g)].map(([, name, code]) => [name, Number(code)]),
  );
  const texts = [...projectText("libcanopen/od/abort_text.hpp").matchAll(/AbortText\{AbortCode::(\w+), "([^"]+)"\}/g)];
  expect(texts.length).toBeGreaterThan(25);
  expect([...kAbortTexts]).toEqual(texts.map(([, name, text]) => [codes.get(name), text]));
});

it("says codes in words", () => {
  expect(abortText(0x06010002)).toBe("0x06010002: read only");
  expect(abortText(1)).toBe("0x00000001: no abort code of CiA 301");
});
