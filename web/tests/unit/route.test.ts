import { expect, test } from "vitest";

import { linkTo, parseRoute } from "../../src/app/route";

test("a link and its route agree", () => {
  const route = parseRoute(linkTo("scope", "vcan0/5", { signals: "1/speed,1/r0063", axis: 2 }));
  expect(route.page).toBe("scope");
  expect(route.unit).toBe("vcan0/5");
  expect(route.query.get("signals")).toBe("1/speed,1/r0063");
  expect(route.query.get("axis")).toBe("2");
});

test("what is no page is the overview", () => {
  expect(parseRoute("").page).toBe("overview");
  expect(parseRoute("#/nonsense/vcan0/5")).toMatchObject({ page: "overview", unit: "" });
});
