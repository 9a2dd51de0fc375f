import { useState } from "preact/hooks";

import { route, usePage } from "./context";
import { hasParameters } from "../model/profile";
import { kPages, linkTo, type PageName } from "./route";
import { nextTheme, theme } from "./theme";
import { TokenDialog } from "./token_dialog";
import { useProfile } from "./use_profile";

/** The unit that is looked at, chosen from all there are. */
function UnitChoice() {
  const { units } = usePage();
  const names = units.all.value.map((unit) => unit.unit);
  const present = route.value.unit || (names[0] ?? "");
  if (names.length === 0) return null;
  const page: PageName = kPages.find((each) => each.page === route.value.page)?.needsUnit ? route.value.page : "scope";
  const all = names.includes(present) ? names : [present, ...names];
  return (
    <label class="unit-choice">
      Unit{" "}
      <select value={present} onChange={(event) => (location.hash = linkTo(page, event.currentTarget.value))}>
        {all.map((name) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
    </label>
  );
}

/** The head of the page: pages, unit, token and theme. */
export function Navigation() {
  const { units, permission, source } = usePage();
  const [asksToken, setAsksToken] = useState(false);
  const unit = route.value.unit || (units.all.value[0]?.unit ?? "");
  const profile = useProfile(unit) ?? "s120";
  const pages = kPages.filter(({ page }) => page !== "parameters" || page === route.value.page || hasParameters(profile));
  return (
    <header class="head">
      <a class="skip" href="#content" onClick={(event) => skip(event)}>
        Skip to the content
      </a>
      <span class="brand">axisd</span>
      <nav aria-label="Pages">
        <ul>
          {pages.map(({ page, title, needsUnit }) => (
            <li key={page}>
              <a href={linkTo(page, needsUnit ? unit : "")} aria-current={route.value.page === page ? "page" : undefined}>
                {title}
              </a>
            </li>
          ))}
        </ul>
      </nav>
      <div class="head-tools">
        <UnitChoice />
        {source.isLive && (
          <button type="button" onClick={() => setAsksToken(true)}>
            {permission.refusal.value === "" ? "Token: right" : permission.server.value?.read_only ? "Read-only" : "Token"}
          </button>
        )}
        <button type="button" onClick={nextTheme} aria-label={`Theme: ${theme.value}`}>
          {{ system: "◐", light: "☀", dark: "☾" }[theme.value]}
        </button>
      </div>
      {asksToken && <TokenDialog onClose={() => setAsksToken(false)} />}
    </header>
  );
}

/** A link within the page would be taken for a route. */
function skip(event: Event): void {
  event.preventDefault();
  document.getElementById("content")?.focus();
}
