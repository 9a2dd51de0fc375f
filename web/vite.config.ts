import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

import { defineConfig, type Plugin } from "vite";

/** Libraries of which the page is made; what each demands to be told is in its LICENSE. */
const kLibraries = ["preact", "@preact/signals", "@preact/signals-core", "uplot"];

function licenses(): string {
  const textOf = (name: string) => readFileSync(new URL(`node_modules/${name}/LICENSE`, import.meta.url), "utf8");
  return kLibraries.map((name) => `${name}\n\n${textOf(name)}`).join("\n----\n\n");
}

/** The licences of the libraries, beside the page. */
function licensesBeside(): Plugin {
  return {
    name: "licenses",
    generateBundle() {
      this.emitFile({ type: "asset", fileName: "licenses.txt", source: licenses() });
    },
  };
}

/** The page as one file, for recorded sessions: `axisctl` puts the session in place of null. */
function sessionPage(): Plugin {
  return {
    name: "session-page",
    enforce: "post",
    generateBundle(_, bundle) {
      const files = Object.values(bundle);
      const page = files.find((file) => file.fileName === "index.html");
      if (page?.type !== "asset") return;
      const style = files
        .filter((file) => file.fileName.endsWith(".css"))
        .map((file) => (file.type === "asset" ? String(file.source) : ""))
        .join("\n");
      const script = files
        .map((file) => (file.type === "chunk" && file.isEntry ? file.code : ""))
        .join("\n")
        .replaceAll("</script", "<\\/script");
      const session = '<script type="application/json" id="session">null</script>';
      const html = String(page.source)
        .replace(/<link rel="stylesheet"[^>]*>\s*/g, "")
        .replace(/<script type="module"[^>]*><\/script>\s*/g, "")
        .replace("</head>", () => `<style>${style}</style>\n</head>`)
        .replace("</body>", () => `<script type="text/plain" id="licenses">${licenses()}</script>\n${session}\n<script type="module">${script}</script>\n</body>`);
      this.emitFile({ type: "asset", fileName: "session.html", source: html });
    },
  };
}

/** What the gateway serves to browsers that take gzip. */
function compressed(): Plugin {
  return {
    name: "compressed",
    enforce: "post",
    generateBundle: {
      order: "post",
      handler(_, bundle) {
        for (const file of Object.values(bundle)) {
          if (file.fileName === "session.html") continue;
          const text = file.type === "chunk" ? file.code : file.source;
          this.emitFile({ type: "asset", fileName: `${file.fileName}.gz`, source: gzipSync(text, { level: 9 }) });
        }
      },
    },
  };
}

export default defineConfig({
  base: "./",
  plugins: [licensesBeside(), sessionPage(), compressed()],
  build: {
    target: "es2022",
    modulePreload: false,
    assetsInlineLimit: 0,
    outDir: process.env["AXISD_WEB_OUT"] ?? "../build/release/share/axisd/web",
    emptyOutDir: true,
  },
  server: { proxy: { "/api": "http://127.0.0.1:8402" } },
  test: { include: ["tests/unit/**/*.test.ts"] },
} as Parameters<typeof defineConfig>[0]);
