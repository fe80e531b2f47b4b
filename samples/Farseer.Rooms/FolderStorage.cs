using System;
using System.IO;
using System.Security.Cryptography;
using System.Threading.Tasks;
using Orleans;
using Orleans.Runtime;
using Orleans.Serialization;
using Orleans.Storage;

namespace Farseer.Rooms;

/// <summary>
/// Keeps the states of grains as files of a folder that all servers reach. Real fleets take a database; Orleans has providers for many.
/// </summary>
internal sealed class FolderStorage : IGrainStorage
{
    private readonly string _folder;
    private readonly Serializer _serializer;

    public FolderStorage(string folder, Serializer serializer)
    {
        _folder = Directory.CreateDirectory(folder).FullName;
        _serializer = serializer;
    }

    public async Task ReadStateAsync<T>(string stateName, GrainId grainId, IGrainState<T> grainState)
    {
        byte[]? bytes = await Read(PathOf(stateName, grainId));
        grainState.State = bytes is null ? Activator.CreateInstance<T>() : _serializer.Deserialize<T>(bytes);
        Note(grainState, bytes);
    }

    public async Task WriteStateAsync<T>(string stateName, GrainId grainId, IGrainState<T> grainState)
    {
        string path = PathOf(stateName, grainId);
        await ThrowIfChanged(path, grainState);
        byte[] bytes = _serializer.SerializeToArray(grainState.State);

        // Whoever reads meanwhile, or after the power has failed, finds the old file or the new one.
        string unfinished = path + ".new";
        await File.WriteAllBytesAsync(unfinished, bytes);
        File.Move(unfinished, path, overwrite: true);
        Note(grainState, bytes);
    }

    public async Task ClearStateAsync<T>(string stateName, GrainId grainId, IGrainState<T> grainState)
    {
        string path = PathOf(stateName, grainId);
        await ThrowIfChanged(path, grainState);
        File.Delete(path);
        grainState.State = Activator.CreateInstance<T>();
        Note(grainState, null);
    }

    private string PathOf(string stateName, GrainId grainId) => Path.Combine(_folder, Uri.EscapeDataString($"{grainId}.{stateName}"));

    private static async Task<byte[]?> Read(string path) => File.Exists(path) ? await File.ReadAllBytesAsync(path) : null;

    /// <summary>
    /// A second activation of the same room, as a net that fell apart can have it, must not write over the first one's state.
    /// </summary>
    private static async Task ThrowIfChanged<T>(string path, IGrainState<T> grainState)
    {
        string? stored = Tag(await Read(path));
        if (stored != grainState.ETag)
        {
            throw new InconsistentStateException($"{Path.GetFileName(path)} was written by somebody else", stored, grainState.ETag);
        }
    }

    private static void Note<T>(IGrainState<T> grainState, byte[]? bytes)
    {
        grainState.RecordExists = bytes is not null;
        grainState.ETag = Tag(bytes);
    }

    private static string? Tag(byte[]? bytes) => bytes is null ? null : Convert.ToHexString(SHA256.HashData(bytes));
}
