using System;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>Compares values in the notation of the scene files.</summary>
public static class ValueComparer
{
    /// <summary>The largest difference of two values, or infinity where they differ in kind, length or text.</summary>
    public static double Difference(JsonElement expected, JsonElement got)
    {
        if (expected.ValueKind == JsonValueKind.Undefined || got.ValueKind == JsonValueKind.Undefined)
        {
            return double.PositiveInfinity;
        }

        if (expected.ValueKind != got.ValueKind)
        {
            return double.PositiveInfinity;
        }

        switch (expected.ValueKind)
        {
            case JsonValueKind.Number:
                return Math.Abs(expected.GetDouble() - got.GetDouble());
            case JsonValueKind.String:
                return expected.GetString() == got.GetString() ? 0 : double.PositiveInfinity;
            case JsonValueKind.Array:
                return expected.GetArrayLength() != got.GetArrayLength()
                    ? double.PositiveInfinity
                    : expected.EnumerateArray().Zip(got.EnumerateArray(), Difference).DefaultIfEmpty(0).Max();
            case JsonValueKind.Object:
                return expected.EnumerateObject().Select(p => Difference(p.Value, Json.Optional(got, p.Name))).DefaultIfEmpty(0).Max();
            default:
                return 0;
        }
    }

    /// <summary>The largest number in a value.</summary>
    public static double Magnitude(JsonElement value) => value.ValueKind switch
    {
        JsonValueKind.Number => Math.Abs(value.GetDouble()),
        JsonValueKind.Array => value.EnumerateArray().Select(Magnitude).DefaultIfEmpty(0).Max(),
        JsonValueKind.Object => value.EnumerateObject().Select(p => Magnitude(p.Value)).DefaultIfEmpty(0).Max(),
        _ => 0,
    };
}
