import type { ComponentType } from "preact";

import { Hands } from "../pages/hands";
import { Fleet } from "../pages/fleet";
import { Objects } from "../pages/objects";
import { Overview } from "../pages/overview";
import { Parameters } from "../pages/parameters";
import { ProcessData } from "../pages/process_data";
import { Scope } from "../pages/scope";
import { States } from "../pages/states";
import { Notice } from "../ui/notice";
import { PageContext, route, usePage, type Page } from "./context";
import { Navigation } from "./navigation";
import { kPages, type PageName } from "./route";

/** What is shown at a route; a page that needs a unit gets its name. */
const kComponents: Record<PageName, ComponentType<{ unit: string }>> = {
  overview: Overview,
  scope: Scope,
  states: States,
  parameters: Parameters,
  objects: Objects,
  "process-data": ProcessData,
  hands: Hands,
  fleet: Fleet,
};

/** Why nobody answers, over the last picture. */
function Absence() {
  const { units } = usePage();
  if (units.absence.value === "") return null;
  const since = units.seenAt.value === 0 ? "" : ` What is shown is of ${new Date(units.seenAt.value).toLocaleTimeString()}.`;
  return <Notice kind="error">{`No answer: ${units.absence.value}.${since}`}</Notice>;
}

function Content() {
  const { units, source } = usePage();
  const { page } = route.value;
  const unit = route.value.unit || (units.all.value[0]?.unit ?? "");
  const Shown = kComponents[page];
  const needsUnit = kPages.some((each) => each.page === page && each.needsUnit);
  if (needsUnit && unit === "" && page !== "scope")
    return <Notice>{source.isLive ? "There is no unit yet: start axisd, it will be found." : "The session has no unit."}</Notice>;
  return <Shown key={`${page} ${unit}`} unit={unit} />;
}

/** The whole page. */
export function App(props: { page: Page }) {
  return (
    <PageContext.Provider value={props.page}>
      <Navigation />
      <main id="content" tabIndex={-1}>
        <Absence />
        <Content />
      </main>
    </PageContext.Provider>
  );
}
