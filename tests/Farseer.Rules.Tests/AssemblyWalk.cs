using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using System.Reflection.Emit;
using System.Reflection.Metadata;
using System.Reflection.Metadata.Ecma335;
using System.Reflection.PortableExecutable;

namespace Farseer.Rules.Tests;

/// <summary>One use of a type or member, seen in the metadata or in the IL of <paramref name="User"/>.</summary>
internal readonly record struct Use(string User, string UsedType, string Member);

/// <summary>
/// Lists what every type of a built assembly uses: base, interfaces, fields, signatures, locals and the tokens of its IL. Text
/// search would miss relative names and inferred types. Blind spot: constants are inlined by the compiler.
/// </summary>
internal sealed class AssemblyWalk : IDisposable
{
    private static readonly Dictionary<int, OpCode> _opCodes = typeof(OpCodes).GetFields()
        .Select(f => (OpCode)f.GetValue(null)!)
        .ToDictionary(o => o.Value & 0xFFFF);

    private readonly PEReader _file;
    private readonly TypeNames _names = new();
    private readonly List<Use> _uses = [];
    private string _user = "";

    public AssemblyWalk(string path)
    {
        _file = new PEReader(File.OpenRead(path));
        Metadata = _file.GetMetadataReader();
    }

    public MetadataReader Metadata { get; }

    public void Dispose() => _file.Dispose();

    public IReadOnlyList<Use> Uses()
    {
        foreach (TypeDefinitionHandle handle in Metadata.TypeDefinitions)
        {
            TypeDefinition type = Metadata.GetTypeDefinition(handle);
            _user = _names.GetTypeFromDefinition(Metadata, handle, 0);
            UseToken(type.BaseType);
            foreach (InterfaceImplementationHandle i in type.GetInterfaceImplementations())
            {
                UseToken(Metadata.GetInterfaceImplementation(i).Interface);
            }

            foreach (FieldDefinitionHandle f in type.GetFields())
            {
                UseTypes(Metadata.GetFieldDefinition(f).DecodeSignature(_names, null));
            }

            foreach (MethodDefinitionHandle m in type.GetMethods())
            {
                WalkMethod(Metadata.GetMethodDefinition(m));
            }
        }

        return _uses;
    }

    private void WalkMethod(MethodDefinition method)
    {
        UseSignature(method.DecodeSignature(_names, null));
        if (method.RelativeVirtualAddress == 0)
        {
            return;
        }

        MethodBodyBlock body = _file.GetMethodBody(method.RelativeVirtualAddress);
        if (!body.LocalSignature.IsNil)
        {
            foreach (string local in Metadata.GetStandaloneSignature(body.LocalSignature).DecodeLocalSignature(_names, null))
            {
                UseTypes(local);
            }
        }

        BlobReader il = body.GetILReader();
        while (il.RemainingBytes > 0)
        {
            int value = il.ReadByte();
            OpCode code = _opCodes[value == 0xFE ? 0xFE00 | il.ReadByte() : value];
            switch (code.OperandType)
            {
                case OperandType.InlineField or OperandType.InlineMethod or OperandType.InlineTok or OperandType.InlineType
                    or OperandType.InlineSig:
                    UseToken(MetadataTokens.EntityHandle(il.ReadInt32()));
                    break;
                case OperandType.InlineSwitch:
                    // Read first: a compound assignment would take the offset from before the count.
                    int targets = il.ReadInt32();
                    il.Offset += 4 * targets;
                    break;
                default:
                    il.Offset += Size(code.OperandType);
                    break;
            }
        }
    }

    private static int Size(OperandType type) => type switch
    {
        OperandType.InlineNone => 0,
        OperandType.ShortInlineBrTarget or OperandType.ShortInlineI or OperandType.ShortInlineVar => 1,
        OperandType.InlineVar => 2,
        OperandType.InlineI8 or OperandType.InlineR => 8,
        _ => 4,
    };

    private void UseToken(EntityHandle handle)
    {
        if (handle.IsNil)
        {
            return;
        }

        switch (handle.Kind)
        {
            case HandleKind.TypeDefinition or HandleKind.TypeReference or HandleKind.TypeSpecification:
                UseTypes(NameOf(handle));
                break;
            case HandleKind.FieldDefinition:
                FieldDefinition field = Metadata.GetFieldDefinition((FieldDefinitionHandle)handle);
                Add(NameOf(field.GetDeclaringType()), Metadata.GetString(field.Name));
                break;
            case HandleKind.MethodDefinition:
                MethodDefinition method = Metadata.GetMethodDefinition((MethodDefinitionHandle)handle);
                Add(NameOf(method.GetDeclaringType()), Metadata.GetString(method.Name));
                UseSignature(method.DecodeSignature(_names, null));
                break;
            case HandleKind.MemberReference:
                MemberReference member = Metadata.GetMemberReference((MemberReferenceHandle)handle);
                Add(NameOf(member.Parent), Metadata.GetString(member.Name));
                break;
            case HandleKind.MethodSpecification:
                MethodSpecification generic = Metadata.GetMethodSpecification((MethodSpecificationHandle)handle);
                UseToken(generic.Method);
                foreach (string argument in generic.DecodeSignature(_names, null))
                {
                    UseTypes(argument);
                }

                break;
        }
    }

    private string NameOf(EntityHandle handle) => handle.Kind switch
    {
        HandleKind.TypeDefinition => _names.GetTypeFromDefinition(Metadata, (TypeDefinitionHandle)handle, 0),
        HandleKind.TypeReference => _names.GetTypeFromReference(Metadata, (TypeReferenceHandle)handle, 0),
        HandleKind.TypeSpecification => _names.GetTypeFromSpecification(Metadata, null, (TypeSpecificationHandle)handle, 0),
        HandleKind.MethodDefinition => NameOf(Metadata.GetMethodDefinition((MethodDefinitionHandle)handle).GetDeclaringType()),
        _ => "",
    };

    private void UseSignature(MethodSignature<string> signature)
    {
        UseTypes(signature.ReturnType);
        foreach (string parameter in signature.ParameterTypes)
        {
            UseTypes(parameter);
        }
    }

    private void UseTypes(string names) => Add(names, "");

    // A constructed type is one name per part, separated by '|'.
    private void Add(string names, string member)
    {
        foreach (string name in names.Split('|', StringSplitOptions.RemoveEmptyEntries))
        {
            _uses.Add(new Use(_user, name, member));
        }
    }

    private sealed class TypeNames : ISignatureTypeProvider<string, object?>
    {
        public string GetTypeFromDefinition(MetadataReader reader, TypeDefinitionHandle handle, byte rawTypeKind)
        {
            TypeDefinition type = reader.GetTypeDefinition(handle);
            return type.GetDeclaringType().IsNil
                ? Full(reader.GetString(type.Namespace), reader.GetString(type.Name))
                : GetTypeFromDefinition(reader, type.GetDeclaringType(), 0) + "/" + reader.GetString(type.Name);
        }

        public string GetTypeFromReference(MetadataReader reader, TypeReferenceHandle handle, byte rawTypeKind)
        {
            TypeReference type = reader.GetTypeReference(handle);
            return type.ResolutionScope.Kind == HandleKind.TypeReference
                ? GetTypeFromReference(reader, (TypeReferenceHandle)type.ResolutionScope, 0) + "/" + reader.GetString(type.Name)
                : Full(reader.GetString(type.Namespace), reader.GetString(type.Name));
        }

        public string GetTypeFromSpecification(MetadataReader reader, object? context, TypeSpecificationHandle handle, byte kind) =>
            reader.GetTypeSpecification(handle).DecodeSignature(this, context);

        public string GetPrimitiveType(PrimitiveTypeCode typeCode) => "";

        public string GetArrayType(string elementType, ArrayShape shape) => elementType;

        public string GetSZArrayType(string elementType) => elementType;

        public string GetByReferenceType(string elementType) => elementType;

        public string GetPointerType(string elementType) => elementType;

        public string GetPinnedType(string elementType) => elementType;

        public string GetGenericMethodParameter(object? genericContext, int index) => "";

        public string GetGenericTypeParameter(object? genericContext, int index) => "";

        public string GetGenericInstantiation(string genericType, ImmutableArray<string> typeArguments) =>
            genericType + "|" + string.Join('|', typeArguments);

        public string GetModifiedType(string modifier, string unmodifiedType, bool isRequired) => unmodifiedType;

        public string GetFunctionPointerType(MethodSignature<string> signature) =>
            signature.ReturnType + "|" + string.Join('|', signature.ParameterTypes);

        private static string Full(string space, string name) => space.Length == 0 ? name : space + "." + name;
    }
}
