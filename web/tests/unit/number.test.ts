import { expect, test } from "vitest";

import { duration, fixed, shown } from "../../src/ui/number";

test("values have so many digits that they can be read", () => {
  expect(shown(3000, "rpm")).toBe("3000\u2009rpm");
  expect(shown(0.123456789)).toBe("0.1235");
  expect(shown(null, "rpm")).toBe("–");
});

test("a changing value keeps its places, and there is no minus zero", () => {
  expect(fixed(-0.0001, 1, "rpm")).toBe("0.0\u2009rpm");
  expect(fixed(-2.25, 2)).toBe("-2.25");
});

test("times are told as people tell them", () => {
  expect(duration(1.5)).toBe("1.500\u2009s");
  expect(duration(192)).toBe("3\u2009min 12\u2009s");
  expect(duration(7500)).toBe("2\u2009h 5\u2009min");
});
