using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;

namespace Farseer.Samples.Tests.Rendering;

/// <summary>A picture as browsers save it: 8 bits a channel, with or without opacity, not interlaced.</summary>
internal sealed class PngPicture
{
    private const int HeaderLength = 8;
    private readonly byte[] _pixels;
    private readonly int _channels;

    private PngPicture(int width, int height, int channels, byte[] pixels)
    {
        Width = width;
        Height = height;
        _channels = channels;
        _pixels = pixels;
    }

    public int Width { get; }

    public int Height { get; }

    public static PngPicture Load(string path)
    {
        byte[] file = File.ReadAllBytes(path);
        int width = 0;
        int height = 0;
        int channels = 0;
        using MemoryStream packed = new();
        for (int at = HeaderLength; at < file.Length;)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at));
            ReadOnlySpan<byte> kind = file.AsSpan(at + 4, 4);
            ReadOnlySpan<byte> data = file.AsSpan(at + 8, length);
            if (kind.SequenceEqual("IHDR"u8))
            {
                width = BinaryPrimitives.ReadInt32BigEndian(data);
                height = BinaryPrimitives.ReadInt32BigEndian(data[4..]);
                channels = (data[8], data[9], data[12]) switch
                {
                    (8, 2, 0) => 3,
                    (8, 6, 0) => 4,
                    _ => throw new InvalidDataException($"{path}: only plain colours of 8 bits are read here."),
                };
            }
            else if (kind.SequenceEqual("IDAT"u8))
            {
                packed.Write(data);
            }

            at += length + 12;
        }

        packed.Position = 0;
        using ZLibStream unpacked = new(packed, CompressionMode.Decompress);
        return new PngPicture(width, height, channels, Unfilter(unpacked, width * channels, height, channels));
    }

    public (int Red, int Green, int Blue) At(int x, int y)
    {
        int at = ((y * Width) + x) * _channels;
        return (_pixels[at], _pixels[at + 1], _pixels[at + 2]);
    }

    /// <summary>Pixels whose channels are all within a tolerance of a colour.</summary>
    public int Count((int Red, int Green, int Blue) color, int tolerance)
    {
        int count = 0;
        for (int y = 0; y < Height; y++)
        {
            for (int x = 0; x < Width; x++)
            {
                (int red, int green, int blue) = At(x, y);
                bool near = Math.Abs(red - color.Red) <= tolerance && Math.Abs(green - color.Green) <= tolerance
                    && Math.Abs(blue - color.Blue) <= tolerance;
                count += near ? 1 : 0;
            }
        }

        return count;
    }

    /// <summary>Each row is stored as its difference from what its neighbours foretell.</summary>
    private static byte[] Unfilter(Stream stream, int stride, int height, int step)
    {
        byte[] pixels = new byte[stride * height];
        for (int y = 0; y < height; y++)
        {
            int filter = stream.ReadByte();
            Span<byte> row = pixels.AsSpan(y * stride, stride);
            stream.ReadExactly(row);
            for (int x = 0; x < stride; x++)
            {
                int left = x >= step ? row[x - step] : 0;
                int up = y > 0 ? pixels[((y - 1) * stride) + x] : 0;
                int corner = x >= step && y > 0 ? pixels[((y - 1) * stride) + x - step] : 0;
                row[x] += (byte)(filter switch
                {
                    1 => left,
                    2 => up,
                    3 => (left + up) / 2,
                    4 => Paeth(left, up, corner),
                    _ => 0,
                });
            }
        }

        return pixels;
    }

    private static int Paeth(int left, int up, int corner)
    {
        int toLeft = Math.Abs(up - corner);
        int toUp = Math.Abs(left - corner);
        int toCorner = Math.Abs(left + up - (2 * corner));
        if (toLeft <= toUp && toLeft <= toCorner)
        {
            return left;
        }

        return toUp <= toCorner ? up : corner;
    }
}
