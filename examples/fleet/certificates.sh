#!/bin/sh
# certificates.sh FOLDER NAME...: a certificate authority of your own in FOLDER, and a certificate of the NATS server for the host
# names and addresses NAME. Hosts of the farm need FOLDER/ca.crt alone. What is there already stays.
set -eu
[ $# -ge 2 ] || { echo "usage: ${0##*/} FOLDER NAME..." >&2; exit 2; }
folder=$1
shift
names=''
for name; do
  case $name in
    *[!0-9.]*) kind=DNS ;;
    *) kind=IP ;;
  esac
  names="$names${names:+,}$kind:$name"
done
umask 077
mkdir -p "$folder"
cd "$folder"
[ -e ca.key ] || openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 3650 -subj "/CN=axisd farms" \
  -keyout ca.key -out ca.crt 2>/dev/null
[ -e server.key ] || {
  openssl req -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -subj "/CN=$1" -keyout server.key -out server.csr 2>/dev/null
  printf 'subjectAltName=%s\nextendedKeyUsage=serverAuth\n' "$names" >server.ext
  openssl x509 -req -in server.csr -CA ca.crt -CAkey ca.key -CAcreateserial -days 825 -extfile server.ext -out server.crt 2>/dev/null
  rm server.csr server.ext
}
chmod 644 ca.crt server.crt
