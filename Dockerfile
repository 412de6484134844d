# vcrit in a bare Debian 12: the two commands of the README. Each stage is a test of its own:
#   docker build --target demo .   the program and its report, with the packages that the program needs
#   docker build --target test .   the whole test suite
#   docker build -t vcrit .        the packaged program alone: docker run --rm -v "$PWD:/work" vcrit eval scene.toml
FROM debian:12 AS sources
WORKDIR /vcrit
COPY . .

FROM sources AS demo
RUN ./dev demo

FROM sources AS test
RUN ./dev test

FROM sources AS package
RUN ./dev package

FROM debian:12-slim
COPY --from=package /vcrit/build/package/packages/vcrit_*.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends /tmp/vcrit_*.deb && rm -rf /tmp/*.deb /var/lib/apt/lists/*
WORKDIR /work
ENTRYPOINT ["vcrit"]
